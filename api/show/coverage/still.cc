#include "api/show/coverage/still.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "api/show/coverage/sheet.h"
#include "api/show/coverage/tangents.h"
#include "fields/base/angle.h"
#include "fields/base/constants.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"
#include "fields/base/turn.h"

namespace slackwater::api {
namespace {

using Place = Vector3<Enu>;

Place unit(const Place& a, const Place& otherwise) {
  const double size = a.norm();
  return size > 1e-9 ? (1 / size) * a : otherwise;
}

/// The quad of patches that lie together. @param of_all  tangents of the whole sheet
CoverageQuad quad_of(const std::vector<const CoveragePatch*>& patches,
                     const SheetTangents& of_all) {
  CoverageQuad quad;
  Place centre{0, 0, 0}, normal{0, 0, 0};
  std::array<double, patch_states> areas{};
  double area = 0, from_left = 1e300, to_right = -1e300, from_top = 1e300, to_bottom = -1e300;
  for (const CoveragePatch* p : patches) {
    const double weight = std::max(p->area_m2, 1e-12);
    area += weight;
    areas[static_cast<std::size_t>(p->state)] += weight;
    centre = centre + weight * p->centre_m;
    normal = normal + weight * p->normal;
    from_left = std::min(from_left, p->along_m - p->width_m / 2);
    to_right = std::max(to_right, p->along_m + p->width_m / 2);
    from_top = std::min(from_top, p->down_m - p->height_m / 2);
    to_bottom = std::max(to_bottom, p->down_m + p->height_m / 2);
  }
  quad.area_m2 = area;
  quad.centre_m = (1 / area) * centre;
  quad.normal = unit(normal, patches.front()->normal);
  quad.state =
      static_cast<PatchState>(std::max_element(areas.begin(), areas.end()) - areas.begin());
  SheetTangents own = tangents_of(patches);
  double half_wide = (to_right - from_left) / 2, half_high = (to_bottom - from_top) / 2;
  if (!own.is_known) {
    // Upright surfaces lie level along; of a flat one the sheet knows the way.
    const bool is_upright = std::abs(quad.normal.z()) < 0.95;
    const Place along = !is_upright && of_all.is_known
                            ? of_all.along - dot(of_all.along, quad.normal) * quad.normal
                            : cross({0, 0, 1}, quad.normal);
    own.along = unit(along, {1, 0, 0});
    own.down = cross(quad.normal, own.along);
    const double side = std::sqrt(area / std::max(1e-12, 4 * half_wide * half_high));
    half_wide *= std::min(1.0, side);
    half_high *= std::min(1.0, side);
  }
  const Place a = half_wide * own.along, d = half_high * own.down;
  quad.corners_m = {quad.centre_m - a - d, quad.centre_m + a - d, quad.centre_m + a + d,
                    quad.centre_m - a + d};
  return quad;
}

/// Directions of a picture in space.
struct View {
  double from_deg = 0;  ///< bearing of the eye
  Place eye{0, 0, 0};   ///< unit, towards the eye
  Place right{0, 0, 0};
  Place up{0, 0, 0};

  explicit View(double bearing_deg) : from_deg(bearing_deg) {
    const double a = bearing_deg * constants::degree, e = 25 * constants::degree;
    eye = {std::sin(a) * std::cos(e), std::cos(a) * std::cos(e), std::sin(e)};
    right = {-std::cos(a), std::sin(a), 0};
    up = cross(eye, right);
  }
  [[nodiscard]] bool is_facing(const Place& normal) const { return dot(normal, eye) > 0.02; }
  [[nodiscard]] double share_facing(const std::vector<CoverageQuad>& quads) const {
    double all = 0, facing = 0;
    for (const CoverageQuad& quad : quads) {
      all += quad.area_m2;
      if (is_facing(quad.normal)) facing += quad.area_m2;
    }
    return all > 0 ? facing / all : 1;
  }
  [[nodiscard]] std::string words() const {
    constexpr const char* sides[] = {"north", "north-east", "east", "south-east",
                                     "south", "south-west", "west", "north-west"};
    return std::string("from the ") + sides[std::lround(from_deg / 45) % 8];
  }
};

std::vector<View> views_of(const std::vector<CoverageQuad>& quads) {
  Place looked{0, 0, 0};
  double area = 0;
  for (const CoverageQuad& quad : quads) {
    area += quad.area_m2;
    if (quad.state != PatchState::unseen) looked = looked + quad.area_m2 * quad.normal;
  }
  double bearing = 225;
  if (std::hypot(looked.x(), looked.y()) > 0.02 * area) {
    bearing = Angle::from_radians(std::atan2(looked.x(), looked.y())).degrees();
    bearing = compass_deg(45 * std::round(bearing / 45) + 360);
  }
  std::vector<View> views{View(bearing)};
  if (views[0].share_facing(quads) < 0.85) views.emplace_back(compass_deg(bearing + 180));
  return views;
}

/// One view in its part of the picture, px.
struct Panel {
  const View* view = nullptr;
  double left = 0, top = 0, wide = 0, high = 0;
  double per_m = 1;
  double middle_x = 0, middle_y = 0;  ///< of what is drawn, along right and up, m

  [[nodiscard]] double x(const Place& place) const {
    return left + wide / 2 + per_m * (dot(place, view->right) - middle_x);
  }
  [[nodiscard]] double y(const Place& place) const {
    return top + high / 2 - per_m * (dot(place, view->up) - middle_y);
  }
};

struct Extent {
  double low = 1e300, high = -1e300;
  void take(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
  [[nodiscard]] double size() const { return high - low; }
  [[nodiscard]] double middle() const { return (low + high) / 2; }
};

std::string polygon_svg(const char* kind, const Panel& panel, const std::array<Place, 4>& corners) {
  std::string d;
  for (const Place& corner : corners)
    d += formatted("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", panel.x(corner), panel.y(corner));
  return formatted("<path class=\"{}\" d=\"{}z\"/>", kind, d);
}

/// Bounds of all that is drawn, in space.
struct Bounds {
  Extent x, y, z;
  explicit Bounds(const std::vector<CoverageQuad>& quads) {
    for (const CoverageQuad& quad : quads)
      for (const Place& corner : quad.corners_m) {
        x.take(corner.x());
        y.take(corner.y());
        z.take(corner.z());
      }
  }
  /// Near enough to belong into the picture.
  [[nodiscard]] bool has_sea() const {
    const double reach = 0.15 * std::max({x.size(), y.size(), z.size()});
    return z.low <= reach && z.high >= -reach;
  }
  [[nodiscard]] std::array<Place, 4> sea() const {
    const double half = 0.62 * std::max({x.size(), y.size(), 0.1 * z.size()});
    const double e = x.middle(), n = y.middle();
    return {Place{e - half, n - half, 0}, Place{e + half, n - half, 0},
            Place{e + half, n + half, 0}, Place{e - half, n + half, 0}};
  }
};

/// A ring on the ground with an arrow to north.
std::string north_svg(const View& view, double x, double y) {
  const double dx = 15 * dot({0, 1, 0}, view.right), dy = -15 * dot({0, 1, 0}, view.up);
  const double size = std::hypot(dx, dy), ux = dx / size, uy = dy / size;
  return formatted("<ellipse class=\"tick\" cx=\"{:.1f}\" cy=\"{:.1f}\" rx=\"15\" ry=\"{:.1f}\"/>",
                   x, y, 15 * view.eye.z()) +
         formatted("<path class=\"arrow\" d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\"/>", x - dx, y - dy,
                   x + dx, y + dy) +
         formatted("<path class=\"mark full\" d=\"M{:.1f} {:.1f}l{:.1f} {:.1f} {:.1f} {:.1f}z\"/>",
                   x + dx, y + dy, -6 * ux - 3 * uy, -6 * uy + 3 * ux, 6 * uy, -6 * ux) +
         formatted(
             "<text class=\"compass\" text-anchor=\"middle\" x=\"{:.1f}\" "
             "y=\"{:.1f}\">N</text>",
             x + dx + 9 * ux, y + dy + 9 * uy + 4);
}

std::string panel_svg(const Panel& panel, std::vector<CoverageQuad> quads, const Bounds& bounds,
                      const std::vector<CoverageMark>& marks) {
  const View& view = *panel.view;
  std::erase_if(quads, [&](const CoverageQuad& quad) { return !view.is_facing(quad.normal); });
  std::stable_sort(quads.begin(), quads.end(), [&](const auto& a, const auto& b) {
    return dot(a.centre_m, view.eye) < dot(b.centre_m, view.eye);
  });
  std::string below, above;
  for (const CoverageQuad& quad : quads) {
    constexpr const char* kinds[] = {"quad state0", "quad state1", "quad state2"};
    (quad.centre_m.z() < 0 ? below : above) +=
        polygon_svg(kinds[static_cast<std::size_t>(quad.state)], panel, quad.corners_m);
  }
  std::string svg = below;
  // Seen from above, the sea lies before all below it and behind all above.
  if (bounds.has_sea()) {
    svg += polygon_svg("water", panel, bounds.sea());
    double x = 1e300, y = 0;
    for (const Place& corner : bounds.sea())
      if (panel.x(corner) < x) {
        x = panel.x(corner);
        y = panel.y(corner);
      }
    above += formatted("<text class=\"small\" x=\"{:.1f}\" y=\"{:.1f}\">sea level</text>",
                       std::max(panel.left + 2, x - 4), y - 9);
  }
  svg += above;
  for (const CoverageMark& mark : marks)
    if (view.is_facing(mark.normal))
      svg += mark_svg(mark, panel.x(mark.place_m), panel.y(mark.place_m));
  const double foot = panel.top + panel.high + 22;
  const double bar_m = round_length(52 / panel.per_m);
  svg += formatted("<path class=\"bar\" d=\"M{:.1f} {:.1f}v8v-4h{:.1f}v-4v8\"/>", panel.left + 46,
                   foot - 4, bar_m * panel.per_m) +
         formatted("<text x=\"{:.1f}\" y=\"{:.1f}\">{:g} m</text>",
                   panel.left + 52 + bar_m * panel.per_m, foot + 4, bar_m) +
         north_svg(view, panel.left + 20, foot) +
         formatted(
             "<text class=\"axis\" text-anchor=\"middle\" x=\"{:.1f}\" "
             "y=\"{:.1f}\">{}</text>",
             panel.left + panel.wide / 2, panel.top - 12, view.words());
  return svg;
}

}  // namespace

std::vector<CoverageQuad> quads_of(const InspectionCoverage& coverage, std::size_t most) {
  const CoverageSheet& sheet = coverage.sheet;
  const double cell_m = std::sqrt(sheet.width_m * sheet.height_m /
                                  static_cast<double>(std::max<std::size_t>(1, most)));
  // Few patches stay by themselves.
  const bool gathers = coverage.patches.size() > most;
  std::map<std::pair<long, long>, std::vector<const CoveragePatch*>> cells;
  std::vector<const CoveragePatch*> all;
  long alone = 0;
  for (const CoveragePatch& patch : coverage.patches) {
    all.push_back(&patch);
    const std::pair<long, long> cell =
        gathers ? std::pair{std::lround(std::floor(patch.down_m / cell_m)),
                            std::lround(std::floor(patch.along_m / cell_m))}
                : std::pair{alone++, 0L};
    cells[cell].push_back(&patch);
  }
  const SheetTangents of_all = tangents_of(all);
  std::vector<CoverageQuad> quads;
  for (const auto& [cell, patches] : cells) quads.push_back(quad_of(patches, of_all));
  return quads;
}

std::string still_svg(const InspectionCoverage& coverage, const std::vector<CoverageMark>& marks) {
  const std::vector<CoverageQuad> quads = quads_of(coverage, still_quads);
  if (quads.empty()) return {};
  const Bounds bounds(quads);
  const std::vector<View> views = views_of(quads);
  std::vector<Panel> panels;
  Extent widest, highest;
  for (const View& view : views) {
    Extent across, up;
    const auto take = [&](const Place& place) {
      across.take(dot(place, view.right));
      up.take(dot(place, view.up));
    };
    for (const CoverageQuad& quad : quads)
      for (const Place& corner : quad.corners_m) take(corner);
    if (bounds.has_sea())
      for (const Place& corner : bounds.sea()) take(corner);
    Panel panel;
    panel.view = &view;
    panel.middle_x = across.middle();
    panel.middle_y = up.middle();
    widest.take(across.size());
    highest.take(up.size());
    panels.push_back(panel);
  }
  // Beside each other what is high, above each other what is wide.
  const bool is_beside = panels.size() == 2 && highest.high > 0.8 * widest.high;
  const double wide = is_beside ? 176 : 354;
  const double per_m =
      std::min(wide / widest.high, (panels.size() == 1 || is_beside ? 370 : 170) / highest.high);
  const double high = highest.high * per_m;
  double bottom = 0;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    Panel& panel = panels[k];
    panel.left = is_beside && k == 1 ? 187 : 6;
    panel.top = 30 + (is_beside || k == 0 ? 0.0 : high + 82);
    panel.wide = wide;
    panel.high = high;
    panel.per_m = per_m;
    bottom = panel.top + high + 46;
  }
  std::string svg = formatted(
      "<svg role=\"img\" aria-label=\"{} in space, {}\" viewBox=\"0 0 366 {:.0f}\">",
      escaped_html(coverage.name()),
      views[0].words() + (views.size() > 1 ? " and " + views[1].words() : std::string()), bottom);
  for (const Panel& panel : panels) svg += panel_svg(panel, quads, bounds, marks);
  return svg + "</svg>";
}

}  // namespace slackwater::api
