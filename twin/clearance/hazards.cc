#include "twin/clearance/hazards.h"

#include <variant>

#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

/// Something upright: the places nearer than the radius to a stretch, between two depths.
struct Upright {
  Stretch stretch;
  double radius_m = 0;
  double top_m = 0;
  double bottom_m = 0;
};

double between_depths_m(const Claim& own, double top_m, double bottom_m) noexcept {
  return std::max(top_m - own.bottom_m, own.top_m - bottom_m);
}

/// What one has its depth from.
struct Depths {
  double top_m = 0;
  double bottom_m = 0;
  Hazard hazard = Hazard::none;
};

void keep_depth(const Claim& claim, const Depths& of, double stand_off_m, double share,
                Cell& cell) noexcept {
  const double above = of.top_m - claim.bottom_m, below = claim.top_m - of.bottom_m;
  if (above > below)
    cell.keep_above(claim.bottom_m + share * (above - stand_off_m), of.hazard);
  else
    cell.keep_below(claim.top_m - share * (below - stand_off_m), of.hazard);
}

/// From the place of the claim that is nearest to it; of a claim that lies across it, from where
/// the vehicle is.
void keep_aside(const Upright& hazard, Hazard what, double stand_off_m, const Outlook& own,
                Cell& cell) noexcept {
  const double apart_m = stand_off_m + hazard.radius_m + own.claim.radius_m;
  NearestPlaces near = nearest_places(own.claim.stretch, hazard.stretch);
  if (size_of(near.on_b - near.on_a) < 1e-6)
    near = {own.position_m, nearest_on(hazard.stretch, own.position_m)};
  const Slack slack{
      size_of(near.on_b - near.on_a) - apart_m,
      between_depths_m(own.claim, hazard.top_m, hazard.bottom_m) - own.stand_off.vertical_m};
  if (slack.aside_m > own.reach_m) return;
  if (slack.is_by_depth()) {
    if (!own.handling->is_afloat)
      keep_depth(own.claim, {hazard.top_m, hazard.bottom_m, what}, own.stand_off.vertical_m, 1,
                 cell);
    return;
  }
  Plane plane;
  plane.normal = unit_of(near.on_b - near.on_a, {1, 0});
  plane.limit_m = dot(plane.normal, near.on_b) - apart_m;
  plane.hazard = what;
  cell.add(plane, own.claim.stretch);
}

Upright upright(const Cylinder& c) noexcept {
  const Planar axis{c.north_m, c.east_m};
  return {{axis, axis}, c.radius_m, c.top_m, c.bottom_m};
}

Planar corner_of(const Box& b, double forward, double aside) noexcept {
  const double x = forward * b.half_size_m.x, y = aside * b.half_size_m.y;
  return {b.centre_m.x + b.heading_cosine * x - b.heading_sine * y,
          b.centre_m.y + b.heading_sine * x + b.heading_cosine * y};
}

/// The side of a box that is nearest to the claim: from outside, all of the box lies behind it.
Upright nearest_side(const Box& b, const Stretch& from) noexcept {
  const Planar corner[4] = {corner_of(b, 1, 1), corner_of(b, 1, -1), corner_of(b, -1, -1),
                            corner_of(b, -1, 1)};
  Upright best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 4; ++i) {
    const Stretch side{corner[i], corner[(i + 1) % 4]};
    const NearestPlaces near = nearest_places(from, side);
    const double away = size_of(near.on_a - near.on_b);
    if (away < least) {
      least = away;
      best.stretch = side;
    }
  }
  best.top_m = b.centre_m.z - b.half_size_m.z;
  best.bottom_m = b.centre_m.z + b.half_size_m.z;
  return best;
}

}  // namespace

void keep_clear_of(const Structure& structure, const Outlook& own, Cell& cell) noexcept {
  const auto* cylinder = std::get_if<Cylinder>(&structure);
  const auto* box = std::get_if<Box>(&structure);
  if (cylinder != nullptr)
    keep_aside(upright(*cylinder), Hazard::structure, own.stand_off.structure_m, own, cell);
  if (box != nullptr)
    keep_aside(nearest_side(*box, own.claim.stretch), Hazard::structure, own.stand_off.structure_m,
               own, cell);
}

void keep_clear_of(const Line& line, bool is_own, const Outlook& own, Cell& cell) noexcept {
  if (!line.is_whole || (is_own && !own.handling->is_afloat)) return;
  const double attached_m = own.handling->radius_m + 2 * own.stand_off.tether_m;
  double from_end_m = 0;
  for (std::size_t i = tether_nodes - 1; i > 0; --i) {
    const Triple<double>&a = line.node_m[i - 1], &b = line.node_m[i];
    const Triple<double> along = b - a;
    from_end_m += std::sqrt(dot(along, along));
    if (is_own && from_end_m < attached_m) continue;
    const Upright piece{{planar(a), planar(b)}, 0, std::min(a.z, b.z), std::max(a.z, b.z)};
    keep_aside(piece, Hazard::line, own.stand_off.tether_m, own, cell);
  }
}

void keep_clear_of(const Craft& other, std::ptrdiff_t whose, const Craft& self, const Outlook& own,
                   Cell& cell) noexcept {
  // Both see the same two claims, those of the last barrier, and so the same plane between them.
  const double apart_m = own.stand_off.craft_m + self.claim.radius_m + other.claim.radius_m;
  NearestPlaces near = nearest_places(self.claim.stretch, other.claim.stretch);
  if (size_of(near.on_b - near.on_a) < 1e-6) near = {self.position_m, other.position_m};
  const Slack slack{size_of(near.on_b - near.on_a) - apart_m,
                    between_depths_m(self.claim, other.claim.top_m, other.claim.bottom_m) -
                        own.stand_off.vertical_m};
  const double share = other.obeys ? 0.5 : 1.0;
  if (share * slack.aside_m > own.reach_m) return;
  if (slack.is_by_depth()) {
    if (!own.handling->is_afloat)
      keep_depth(self.claim, {other.claim.top_m, other.claim.bottom_m, Hazard::vehicle},
                 own.stand_off.vertical_m, other.keeps_level ? 1 : share, cell);
    return;
  }
  Plane plane;
  plane.normal = unit_of(near.on_b - near.on_a, {1, 0});
  plane.limit_m = dot(plane.normal, near.on_a) + share * slack.aside_m;
  plane.whose = whose;
  plane.hazard = Hazard::vehicle;
  cell.add(plane, own.claim.stretch);
}

double leaving_time_s(const Handling& h, double half_breadth_m) noexcept {
  const double turn_s =
      h.manner == Manner::pushes ? 0 : constants::pi / std::max(h.most_yaw_rate_rad_s, 1e-3);
  // Stopping first, should it go the wrong way.
  return turn_s + 2 * (h.reaction_s + h.most_speed_m_s / h.deceleration_m_s2) +
         2 * half_breadth_m / h.sure_speed_m_s;
}

Encounter keep_clear_of(const Passer& passer, const Outlook& own, Cell& cell) noexcept {
  const double apart_m = own.stand_off.vessel_m + own.claim.radius_m + passer.half_beam_m;
  const double in_depth_m =
      between_depths_m(own.claim, passer.top_m, passer.bottom_m) - own.stand_off.vertical_m;
  const Hazard what = passer.is_of_run ? Hazard::vehicle : Hazard::vessel;
  const double speed = size_of(passer.velocity_m_s);
  const Planar ahead = unit_of(passer.velocity_m_s, {1, 0}), right = to_the_right(ahead);
  const double leaving_s = leaving_time_s(*own.handling, apart_m);
  // As long as what goes slower than that is a hull that drifts.
  constexpr double adrift_m_s = 0.3;
  const bool sails = speed > adrift_m_s;
  const double bow_m = passer.half_length_m, end_m = bow_m + apart_m + speed * leaving_s;
  const Planar from = own.claim.stretch.from - passer.position_m;
  const Planar to = own.claim.stretch.to - passer.position_m;
  const double most_along = std::max(dot(from, ahead), dot(to, ahead));
  const double least_along = std::min(dot(from, ahead), dot(to, ahead));
  Encounter encounter;
  if (!sails || most_along < -bow_m) {
    const Planar reach = (sails ? passer.half_length_m : 0.0) * ahead;
    Upright hull{{passer.position_m - reach, passer.position_m + reach},
                 sails ? passer.half_beam_m : passer.half_length_m,
                 passer.top_m,
                 passer.bottom_m};
    keep_aside(hull, what, own.stand_off.vessel_m, own, cell);
    return encounter;
  }
  if (least_along > end_m) return encounter;
  // Its side is that on which its claim ends.
  const double across = dot(to, right);
  const double side = across < 0 ? -1 : 1;
  const double nearest_m = std::min(side * dot(from, right), side * across);
  const Slack slack{nearest_m - apart_m, in_depth_m};
  if (slack.aside_m > own.reach_m) return encounter;
  if (slack.is_by_depth()) {
    if (!own.handling->is_afloat)
      keep_depth(own.claim, {passer.top_m, passer.bottom_m, what}, own.stand_off.vertical_m, 1,
                 cell);
    return encounter;
  }
  encounter.is_ahead = true;
  encounter.off_course = side * right;
  const double missing_m = apart_m - side * dot(own.position_m - passer.position_m, right);
  encounter.is_in_the_way = missing_m > 0;
  const double left_s = (least_along - bow_m) / speed;
  encounter.is_too_late = slack.aside_m < -1e-2 &&
                          left_s < leaving_time_s(*own.handling, 0.5 * std::max(missing_m, 0.0));
  Plane plane;
  plane.normal = -side * right;
  plane.limit_m = dot(plane.normal, passer.position_m) - apart_m;
  plane.whose = Plane::course;
  plane.hazard = what;
  // Near the edge of it the vehicle goes no deeper; farther in, it may have to go round something.
  constexpr double edge = 0.25;
  if (missing_m > edge * apart_m) return encounter;
  constexpr double loose = 0.02;
  if (encounter.is_in_the_way)
    plane.limit_m += loose * apart_m - std::min(plane.room_m(own.claim.stretch), 0.0);
  cell.add(plane, own.claim.stretch);
  return encounter;
}

}  // namespace slackwater::twin
