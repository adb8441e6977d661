#include "twin/clearance/clear_way.h"

namespace slackwater::twin {
namespace {

constexpr double steps_ahead = 2;
constexpr double touch_m = 1e-9;
/// Of a claim, beyond what the vehicle strays: no alarm is raised for rounding.
constexpr double alarm_m = 0.01;

struct Look {
  const Handling& handling;
  const OwnMotion& own;
  const Lookout& lookout;
  double dt_s = 0;
  Claim claim;
  Cell cell;

  [[nodiscard]] Planar at(const Planar& way_m) const noexcept { return own.position_m + way_m; }
  /// Of its middle: of one that circles that of its circle.
  [[nodiscard]] const Planar& here() const noexcept { return claim.stretch.from; }
  [[nodiscard]] double more_s() const noexcept {
    return handling.early * handling.reaction_s + steps_ahead * dt_s;
  }
  [[nodiscard]] double time_for(double speed_m_s) const noexcept {
    return handling.reaction_s + more_s() + speed_m_s / (2 * handling.deceleration_m_s2);
  }
  /// The plane that a way crosses by the most; null: it crosses none.
  [[nodiscard]] const Plane* bar_of(const Planar& way_m) const noexcept {
    const Plane* bar = nullptr;
    double least = -1e-9;
    for (const Plane& plane : cell.planes()) {
      const double room = plane.room_m(at(way_m));
      if (room < least) {
        least = room;
        bar = &plane;
      }
    }
    return bar;
  }
};

OwnMotion moved(const OwnMotion& own, const Planar& velocity_m_s, const Planar& bow, double dt_s) {
  OwnMotion next = own;
  next.position_m = own.position_m + dt_s * own.velocity_m_s;
  next.velocity_m_s = velocity_m_s;
  next.bow = bow;
  return next;
}

/// Whether two claims of the next moment, of the motion kept and of the one that is told, cross no
/// plane. One that the vehicle itself is beyond is left by what leads back.
bool are_in_cell(const Look& look, const Claim& kept, const Claim& told) noexcept {
  for (const Plane& plane : look.cell.planes()) {
    const double if_kept = plane.room_m(kept.stretch), if_told = plane.room_m(told.stretch);
    if (plane.room_m(look.here()) >= 0) {
      if (std::min(if_kept, if_told) < -touch_m) return false;
    } else if (if_told < std::min(if_kept, plane.room_m(look.claim.stretch)) - touch_m) {
      return false;
    }
  }
  return true;
}

Planar turned(const Planar& bow, const Planar& towards, double most_rad) noexcept {
  const double sine = dot(to_the_right(bow), towards), cosine = dot(bow, towards);
  const double turn = std::clamp(std::atan2(sine, cosine), -most_rad, most_rad);
  return std::cos(turn) * bow + std::sin(turn) * to_the_right(bow);
}

/// Whether it can still stop in its cell after a step towards a velocity, be it followed or not.
bool can_still_stop(const Look& look, const Planar& velocity_m_s) noexcept {
  const Handling& h = look.handling;
  const OwnMotion& own = look.own;
  const Planar change = velocity_m_s - own.velocity_m_s;
  double most = h.acceleration_m_s2;
  if (h.manner == Manner::turns)
    most = std::max(most, size_of(own.velocity_m_s) * h.most_yaw_rate_rad_s);
  const double size = size_of(change);
  const double share = size > most * look.dt_s ? most * look.dt_s / size : 1.0;
  const Planar next = own.velocity_m_s + share * change;
  return are_in_cell(look, claim_of(h, moved(own, own.velocity_m_s, own.bow, look.dt_s)),
                     claim_of(h, moved(own, next, own.bow, look.dt_s)));
}

/// Whether its circle is in its cell after a step in which it turns that way, and after it has gone
/// on with that for as long as it takes to do otherwise. From beyond a plane only what leads back
/// will do: beside others that come nearer, to go along it is not enough.
bool can_still_circle(const Look& look, const Planar& towards) noexcept {
  const Handling& h = look.handling;
  constexpr double leads_back = 0.3;
  for (const double time_s : {look.dt_s, h.reaction_s}) {
    OwnMotion next = look.own;
    next.bow = turned(look.own.bow, towards, h.most_yaw_rate_rad_s * time_s);
    next.position_m = look.own.position_m + time_s * look.own.velocity_m_s;
    const Claim claim = claim_of(h, next);
    const double way_m = leads_back * time_s * size_of(look.own.velocity_m_s);
    for (const Plane& plane : look.cell.planes()) {
      const double now = plane.room_m(look.here());
      const double least = now < 0 ? std::min(now + way_m, 0.0) : 0.0;
      if (plane.room_m(claim.stretch) < least - touch_m) return false;
    }
  }
  return true;
}

/// Where the bow will point on that course: it leads by as much as it does now.
Planar bow_on(const OwnMotion& own, const Planar& course) noexcept {
  const Planar now = unit_of(own.velocity_m_s, own.bow);
  const double sine = dot(to_the_right(now), course), cosine = dot(now, course);
  return unit_of(cosine * own.bow + sine * to_the_right(own.bow), own.bow);
}

/// Out of the way of whoever has the right of way and is held up by this one.
Planar giving_way(const StandOff& stand_off, const Lookout& lookout) noexcept {
  const Craft& self = lookout.craft[lookout.own];
  Planar off;
  for (std::size_t i = 0; i < lookout.craft.size(); ++i) {
    const Craft& other = lookout.craft[i];
    const bool has_right = other.is_leaving == self.is_leaving ? i < lookout.own : other.is_leaving;
    if (i == lookout.own || !has_right || !other.obeys ||
        other.hindered_by != static_cast<std::ptrdiff_t>(lookout.own))
      continue;
    const Planar ahead = unit_of(other.wish_m, {});
    const Planar right = to_the_right(ahead);
    const Planar from = self.position_m - other.position_m;
    const double apart_m = 1.5 * stand_off.craft_m + self.claim.radius_m + other.claim.radius_m;
    const double across = dot(from, right);
    if (dot(from, ahead) < -apart_m || std::abs(across) > apart_m) continue;
    off = off + (across < 0 ? -1.0 : 1.0) * right;
  }
  return off;
}

/// Along what bars the way, on the side that was chosen; at a corner along the next.
Planar round_it(const Look& look, const Planar& wanted_m, double side) noexcept {
  const double size = size_of(wanted_m);
  Planar way = wanted_m;
  for (int i = 0; i < 4; ++i) {
    const Plane* bar = look.bar_of(way);
    if (bar == nullptr) break;
    way = size * side * to_the_right(bar->normal);
  }
  return way;
}

/// The shortest way out of what the vehicle is in already, where nothing is clear.
Planar way_out(const Look& look) noexcept {
  Planar way;
  for (const Plane& plane : look.cell.planes()) {
    const double room = plane.room_m(look.own.position_m);
    if (room < 0) way = way + room * plane.normal;
  }
  return way;
}

/// Whether what bars the way will still be there: to go round what passes is to chase it.
bool stays(const Look& look, const Plane& bar) noexcept {
  if (bar.whose < 0) return bar.whose == Plane::fixed;
  const Craft& other = look.lookout.craft[static_cast<std::size_t>(bar.whose)];
  constexpr double passing = 0.2;
  return other.hindered_by == static_cast<std::ptrdiff_t>(look.lookout.own) ||
         size_of(other.velocity_m_s) < passing * look.handling.most_speed_m_s;
}

/// Whether a place is too near to a structure to be gone to, at the depth that the vehicle has.
bool is_too_near(const Look& look, const StandOff& stand_off, const Planar& place_m) noexcept {
  const Triple<double> there_m{place_m.north, place_m.east, look.own.depth_m};
  const double least_m = stand_off.structure_m + look.handling.radius_m;
  return std::any_of(
      look.lookout.structures.begin(), look.lookout.structures.end(),
      [&](const Structure& structure) { return signed_distance_m(structure, there_m) < least_m; });
}

/// Whether what is wished for lies beyond what bars the way, and can be gone to at all. A vehicle
/// that is near its place is not to be sent round a pile for a last half metre.
bool leads_past(const Look& look, const StandOff& stand_off, const Wish& wish,
                const Planar& wanted_m) noexcept {
  const Plane* bar = look.bar_of(wanted_m);
  if (!wish.place_m || bar == nullptr) return true;
  const double time_s = look.time_for(size_of(wish.velocity_m_s));
  return bar->room_m(*wish.place_m + time_s * wish.place_m_s) < 0 &&
         !is_too_near(look, stand_off, *wish.place_m);
}

/// Takes up going round, goes on with it, or leaves it.
/// @param is_past  what is wished for lies beyond what bars the way
void choose_side(const Look& look, const Planar& wanted_m, const Planar& way_m, bool is_past,
                 ClearanceState& state) noexcept {
  constexpr double enough = 0.5, clearly = 0.3, patience_s = 120;
  const Plane* bar = look.bar_of(wanted_m);
  const double size = size_of(wanted_m);
  if (bar == nullptr || !(size > 0) || !is_past || !stays(look, *bar)) {
    state.side = 0;
    state.side_s = 0;
    return;
  }
  state.side_s += look.dt_s;
  if (state.side == 0) {
    if (dot(way_m, wanted_m) > enough * size * size) return;
    const double to_the_right_of_it = dot(to_the_right(bar->normal), wanted_m) / size;
    state.side = bar->whose < 0 && to_the_right_of_it < -clearly ? -1 : 1;
    state.side_s = 0;
  } else if (state.side_s > patience_s) {
    state.side = -state.side;
    state.side_s = 0;
  }
}

Planar clear_circling(const Look& look, const Planar& wanted_m, ClearanceState& state) noexcept {
  choose_side(look, wanted_m, {}, true, state);
  const double side = state.side == 0 ? 1 : state.side;
  for (const Planar& way :
       {wanted_m, round_it(look, wanted_m, side), round_it(look, wanted_m, -side), way_out(look)}) {
    const Planar towards = unit_of(way, {});
    if (towards != Planar{} && can_still_circle(look, towards)) return towards;
  }
  return {};
}

/// The velocity that takes it towards the end of a way, and lets it stop within that.
Planar velocity_for(const Look& look, const Planar& way_m) noexcept {
  const double way = size_of(way_m);
  if (!(way > 1e-9)) return {};
  const Handling& h = look.handling;
  const double speed = std::min(speed_for_way_m_s(h, way, look.more_s()), h.most_speed_m_s);
  // One that is faster still needs its own time to stop, not that of the speed it is to have.
  const double faster = std::max(speed, size_of(look.own.velocity_m_s));
  return (std::min(speed, way / look.time_for(faster)) / way) * way_m;
}

AlarmCause cause_of(Hazard hazard) noexcept {
  switch (hazard) {
    case Hazard::vehicle:
      return AlarmCause::vehicle;
    case Hazard::line:
      return AlarmCause::line;
    case Hazard::vessel:
      return AlarmCause::vessel;
    case Hazard::structure:
    case Hazard::none:
      break;
  }
  return AlarmCause::structure;
}

/// Raises an alarm, lets it go on or ends it.
void note_alarm(const Look& look, bool is_too_late, ClearanceState& state) noexcept {
  const RoomLeft room = look.cell.room_of(look.claim);
  state.slack_m = std::min(room.room_m, 1e6);
  const bool is_outside = state.slack_m < -look.handling.stray_m - alarm_m;
  const bool is_alarmed = is_outside || look.cell.is_crowded() || is_too_late;
  if (is_alarmed && state.is_alarmed == 0) {
    const AlarmCause cause = is_outside    ? cause_of(room.hazard)
                             : is_too_late ? AlarmCause::no_warning
                                           : AlarmCause::crowded;
    ++state.alarms;
    ++state.alarms_from[static_cast<std::size_t>(cause)];
  }
  state.is_alarmed = is_alarmed ? 1 : 0;
}

}  // namespace

const char* name_of(AlarmCause cause) noexcept {
  constexpr std::array<const char*, alarm_causes> names{"vehicle", "structure",  "tether",
                                                        "vessel",  "no_warning", "crowded"};
  return names[static_cast<std::size_t>(cause)];
}

ClearWay clear_way(const Handling& h, const StandOff& stand_off, const Lookout& lookout,
                   const OwnMotion& own, const Wish& wish, double dt_s,
                   ClearanceState& state) noexcept {
  Look look{h, own, lookout, dt_s, claim_of(h, own), {}};
  const double speed = size_of(own.velocity_m_s), wished = size_of(wish.velocity_m_s);
  Planar wanted_m = look.time_for(wished) * wish.velocity_m_s;

  Outlook outlook{&h, stand_off, look.claim, own.position_m, 0};
  outlook.reach_m = look.time_for(wished) * wished + stopping_way_m(h, speed) +
                    2 * h.most_speed_m_s * dt_s + h.turning_radius_m + 1;
  Planar off = giving_way(stand_off, lookout);
  bool is_too_late = false;
  for (const Structure& structure : lookout.structures)
    keep_clear_of(structure, outlook, look.cell);
  for (const Line& line : lookout.lines) {
    // One that hangs from its own deck goes along with it.
    if (line.carrier == static_cast<std::ptrdiff_t>(lookout.own)) continue;
    keep_clear_of(line, line.owner == lookout.own, outlook, look.cell);
  }
  Planar off_course;
  for (const Passer& passer : lookout.passers) {
    if (std::find(lookout.not_of_concern.begin(), lookout.not_of_concern.end(), passer.id) !=
        lookout.not_of_concern.end())
      continue;
    const Encounter met = keep_clear_of(passer, outlook, look.cell);
    if (met.is_in_the_way) off_course = off_course + met.off_course;
    is_too_late = is_too_late || met.is_too_late;
  }
  const Craft& self = lookout.craft[lookout.own];
  for (std::size_t i = 0; i < lookout.craft.size(); ++i) {
    const Craft& other = lookout.craft[i];
    const auto place = static_cast<std::ptrdiff_t>(i);
    const bool is_carried =
        other.carrier == static_cast<std::ptrdiff_t>(lookout.own) || self.carrier == place;
    if (i != lookout.own && other.is_there && !is_carried)
      keep_clear_of(other, place, self, outlook, look.cell);
  }

  // Out of a vessel's way before anything else, then out of that of a vehicle.
  const auto at_full_speed = [&](const Planar& course) -> Planar {
    return look.time_for(h.most_speed_m_s) * h.most_speed_m_s * unit_of(course, {});
  };
  state.is_leaving = off_course != Planar{} ? 1 : 0;
  if (state.is_leaving != 0) off = off_course;
  const bool goes_off = off != Planar{};
  if (state.is_leaving != 0) wanted_m = at_full_speed(off);
  const Plane* bar = look.bar_of(wanted_m);
  state.wish_m = wanted_m;
  state.hindered_by = bar == nullptr ? -1 : std::max(static_cast<double>(bar->whose), -1.0);
  if (goes_off) wanted_m = at_full_speed(off);

  ClearWay out;
  const bool circles = h.manner == Manner::circles;
  const Planar ahead = h.manner == Manner::turns ? wished * own.bow : wish.velocity_m_s;
  if (circles) {
    out.is_as_wished_aside = !goes_off && can_still_circle(look, bow_on(own, wish.velocity_m_s));
    if (!out.is_as_wished_aside)
      out.velocity_m_s = clear_circling(look, wanted_m, state);
    else
      state.side = state.side_s = 0;
  } else {
    out.is_as_wished_aside = !goes_off && bar == nullptr && can_still_stop(look, ahead);
    Planar end = look.at(wanted_m);
    const bool has_room = nearest_in(look.cell, end, end);
    Planar way = has_room ? end - own.position_m : way_out(look);
    choose_side(look, wanted_m, way, leads_past(look, stand_off, wish, wanted_m), state);
    if (!out.is_as_wished_aside) {
      if (has_room && state.side != 0) {
        end = look.at(round_it(look, wanted_m, state.side));
        if (nearest_in(look.cell, end, end)) way = end - own.position_m;
      }
      out.velocity_m_s = velocity_for(look, way);
      Planar target = out.velocity_m_s;
      if (h.manner == Manner::turns) target = dot(own.bow, target) * own.bow;
      if (!can_still_stop(look, target)) {
        out.only_turns = size_of(out.velocity_m_s) > 0;
        if (h.manner == Manner::pushes) out.velocity_m_s = {};
      }
    }
  }

  if (!h.is_afloat) {
    out.least_depth_m = look.cell.top_m() + h.above_m;
    out.most_depth_m = look.cell.bottom_m() - h.below_m;
    OwnMotion next = own;
    next.depth_m += steps_ahead * dt_s * wish.down_m_s;
    next.down_m_s = wish.down_m_s;
    const Claim planned = claim_of(h, next);
    const double top_m = std::min(planned.top_m, look.claim.top_m);
    const double bottom_m = std::max(planned.bottom_m, look.claim.bottom_m);
    out.is_as_wished_in_depth = top_m >= look.cell.top_m() && bottom_m <= look.cell.bottom_m();
  }

  note_alarm(look, is_too_late, state);
  if (!out.is_as_wished_aside || !out.is_as_wished_in_depth) state.changed_s += dt_s;
  return out;
}

Craft craft_of(const Handling& h, const OwnMotion& own, const ClearanceState& state) noexcept {
  Craft craft;
  craft.claim = claim_of(h, own);
  craft.position_m = own.position_m;
  craft.velocity_m_s = own.velocity_m_s;
  craft.wish_m = state.wish_m;
  craft.hindered_by = static_cast<std::ptrdiff_t>(state.hindered_by);
  craft.radius_m = h.radius_m;
  craft.is_leaving = state.is_leaving != 0;
  craft.keeps_level = h.is_afloat;
  return craft;
}

}  // namespace slackwater::twin
