#include "twin/mission/work_pattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/control/patterns.h"
#include "twin/inspection/surface/rotor_axes.h"
#include "twin/inspection/surface/usual_sizes.h"
#include "twin/mission/cable_of_site.h"
#include "twin/mission/read_seconds.h"

namespace slackwater::twin {
namespace {

using constants::degree;
constexpr double turn = 2 * constants::pi;

double hub_of(const Config& config, std::string_view key, const WorkTurbine& turbine) {
  if (turbine.hub_m < 0) return turbine.hub_m;
  config.refuse(key,
                "the site gives turbine " + turbine.id + " no hub_height_m; add it to the site");
}

/// Places on a ring, no more than this apart.
double chord_for(double radius_m) { return std::clamp(0.4 * radius_m, 1.0, 15.0); }

/// In the order in which they are flown. Fewer than the task's are an even number of them, since an
/// odd one would be done twice (`rings`), and as far apart as reaches from the first to the last.
struct Levels {
  std::vector<double> down_m;
};
Levels read_levels(const Config& work, const WorkTurbine& turbine, double spacing_m,
                   const Intensity& intensity) {
  const double from = read_level(work.child("from"), turbine);
  const double to = read_level(work.child("to"), turbine);
  if (std::abs(to - from) < 1e-9) return {{from}};
  const int all =
      1 + std::max(1, static_cast<int>(std::ceil(std::abs(to - from) / spacing_m - 1e-6)));
  int kept = passes_at(all, intensity.density);
  if (kept < all) kept += kept % 2;
  Levels levels;
  for (const int i : flown_order(kept, intensity.order))
    levels.down_m.push_back(from + (to - from) * i / (kept - 1));
  return levels;
}

/// A ring on a level, clockwise or against it.
std::vector<Waypoint> ring(const WorkTurbine& turbine, double radius_m, double bearing_rad,
                           double down_m, bool is_clockwise, double speed_m_s) {
  std::vector<Waypoint> points = orbit({turbine.north_m, turbine.east_m, down_m}, radius_m,
                                       bearing_rad, 1, down_m, chord_for(radius_m), speed_m_s);
  if (!is_clockwise) std::reverse(points.begin(), points.end());
  return points;
}

/// As many rings one way as the other: the last level is done twice where they are odd.
std::vector<WorkLeg> rings(const WorkTurbine& turbine, double radius_m, double bearing_rad,
                           const Levels& levels, double speed_m_s) {
  std::vector<WorkLeg> legs;
  bool is_clockwise = true;
  std::vector<double> down = levels.down_m;
  if (down.size() % 2 == 1) down.push_back(down.back());
  for (const double at_m : down) {
    legs.push_back({ring(turbine, radius_m, bearing_rad, at_m, is_clockwise, speed_m_s), 0});
    is_clockwise = !is_clockwise;
  }
  return legs;
}

double read_stand_off(const Config& work) { return work.number("stand_off_m", {0.2, 200}); }

double read_bearing(const Config& work, const WorkTurbine& turbine) {
  const auto bearing = work.optional_number("bearing_deg", {-360, 360});
  return bearing ? *bearing * degree : turbine.landing_rad;
}

std::vector<WorkLeg> lay_rings(const Config& work, const WorkTurbine& turbine,
                               const Intensity& intensity) {
  const double radius_m = turbine.radius_m + read_stand_off(work);
  const Levels levels = read_levels(work, turbine, work.number("spacing_m", {0.2, 100}), intensity);
  return rings(turbine, radius_m, read_bearing(work, turbine), levels, 0);
}

/// The speed with which a tool of that width cleans an area in an hour.
std::vector<WorkLeg> lay_bands(const Config& work, const WorkTurbine& turbine,
                               const Intensity& intensity) {
  const double swath_m = work.number("swath_m", {0.05, 5});
  const double rate_m2_s = work.number("rate_m2_h", {0.1, 1000}) / 3600;
  const double radius_m = turbine.radius_m + read_stand_off(work);
  const double overlap_m = work.optional_number("overlap_m", {0, 0.9 * swath_m}).value_or(0);
  // Bands further apart would leave growth in between, so that they are done less often instead.
  const int passes =
      passes_at(work.optional_integer("passes", 1, 100).value_or(1), intensity.density);
  // The tool goes along the face, the vehicle on a wider circle.
  const double speed_m_s = rate_m2_s / swath_m * radius_m / turbine.radius_m;
  const std::vector<WorkLeg> once =
      rings(turbine, radius_m, read_bearing(work, turbine),
            read_levels(work, turbine, swath_m - overlap_m, {}), std::max(speed_m_s, 0.01));
  std::vector<WorkLeg> legs;
  for (int pass = 0; pass < passes; ++pass) legs.insert(legs.end(), once.begin(), once.end());
  return legs;
}

/// On a level from one bearing to another, on which side of the first that may lie, without the
/// latter; so far out that the chords clear the circle.
void go_round(const WorkTurbine& turbine, double from, double to, double radius_m, double down_m,
              std::vector<Waypoint>& way) {
  const double sign = to < from ? -1 : 1;
  for (double gone = 0; gone < sign * (to - from) - 1e-9; gone += 20 * degree)
    way.push_back(
        {turbine.around(from + sign * gone, radius_m / std::cos(10 * degree), down_m), 0, 0});
}

std::vector<WorkLeg> lay_verticals(const Config& work, const WorkTurbine& turbine,
                                   const Intensity& intensity) {
  const double radius_m = turbine.radius_m + read_stand_off(work);
  const double from = read_level(work.child("from"), turbine);
  const double to = read_level(work.child("to"), turbine);
  const int bearings =
      passes_at(work.optional_integer("bearings", 1, 72).value_or(4), intensity.density);
  const int stops = work.optional_integer("stops", 0, 1000).value_or(0);
  const double stop_s = stops > 0 ? read_seconds(work, "stop", {1, 86400}) : 0;
  const double first = read_bearing(work, turbine);
  std::vector<WorkLeg> legs;
  std::vector<Waypoint> between;
  double before = first;
  bool is_down = false;
  for (const int i : flown_order(bearings, intensity.order)) {
    const double bearing = first + turn * i / bearings;
    is_down = !is_down;
    const double start = is_down ? from : to, end = is_down ? to : from;
    go_round(turbine, before, bearing, radius_m, start, between);
    between.push_back({turbine.around(bearing, radius_m, start), 0, 0});
    for (int stop = 1; stop <= stops; ++stop) {
      const double at = start + (end - start) * stop / (stops + 1);
      between.push_back({turbine.around(bearing, radius_m, at), 0, 0});
      legs.push_back({between, stop_s});
      between.clear();
    }
    between.push_back({turbine.around(bearing, radius_m, end), 0, 0});
    before = bearing;
  }
  // Back the way it came, so that a line does not lie about the foundation.
  const double last = between.back().position_m.z;
  go_round(turbine, before, first, radius_m, last, between);
  between.push_back({turbine.around(first, radius_m, last), 0, 0});
  legs.push_back({between, 0});
  return legs;
}

std::vector<WorkLeg> lay_circles(const Config& work, const WorkTurbine& turbine) {
  const std::vector<double> radii = work.numbers("radii_m", {1, 10e3});
  if (radii.empty()) work.refuse("radii_m", "missing; give the radii of the circles");
  const double at = read_level(work.child("at"), turbine);
  const double turns = work.optional_number("turns", {0.1, 1000}).value_or(1);
  std::vector<WorkLeg> legs;
  for (const double radius_m : radii) {
    if (radius_m <= turbine.radius_m)
      work.refuse("radii_m", formatted("found {:g} m, inside the foundation's {:g} m", radius_m,
                                       turbine.radius_m));
    legs.push_back(
        {orbit({turbine.north_m, turbine.east_m, at}, radius_m, read_bearing(work, turbine), turns,
               at, std::max(chord_for(radius_m), 0.2 * radius_m), 0),
         0});
  }
  return legs;
}

/// The faces that are flown, in that order: fewer than the task's are as far apart as they go.
std::vector<std::string> faces_of(const Config& work, const Intensity& intensity) {
  std::vector<std::string> all = work.texts("faces");
  if (all.empty()) all = {"leading_edge", "pressure", "trailing_edge", "suction"};
  const int count = static_cast<int>(all.size());
  const int kept = passes_at(count, intensity.density);
  std::vector<std::string> faces;
  for (const int i : flown_order(kept, intensity.order))
    faces.push_back(all[static_cast<std::size_t>(i * count / kept)]);
  return faces;
}

/// Along a blade of a stopped rotor: out on one face, back on the next; between faces that lie
/// across from each other round the blade.
std::vector<WorkLeg> lay_blade(const Config& work, const WorkTurbine& turbine,
                               const Intensity& intensity) {
  const double hub = hub_of(work, "blade", turbine);
  if (!(turbine.rotor_radius_m > 0))
    work.refuse("blade", "the site gives no rotor_diameter_m; add it to the site");
  const double stand_off_m = read_stand_off(work);
  const int blade = work.integer("blade", 1, 3);
  const double faces_rad = work.number("rotor_faces_deg", {-360, 360}) * degree;
  const double first_azimuth_rad =
      work.optional_number("rotor_azimuth_deg", {-360, 360}).value_or(0) * degree;
  const auto [upwind, along, across] =
      blade_axes(faces_rad, blade_azimuth_rad(blade, first_azimuth_rad));
  const Triple<double> hub_m =
      Triple<double>{turbine.north_m, turbine.east_m, hub} + usual::overhang_m * upwind;
  WorkLeg leg;
  bool is_out = true;
  Triple<double> before;
  for (const std::string& face : faces_of(work, intensity)) {
    Triple<double> off;
    if (face == "leading_edge") {
      off = across;
    } else if (face == "trailing_edge") {
      off = -1.0 * across;
    } else if (face == "pressure") {
      off = upwind;
    } else if (face == "suction") {
      off = -1.0 * upwind;
    } else {
      work.refuse("faces",
                  "found " + face + ", expected leading_edge, trailing_edge, pressure or suction");
    }
    const Triple<double> root = hub_m + usual::blade_root_m * along + stand_off_m * off;
    const Triple<double> tip = hub_m + turbine.rotor_radius_m * along + stand_off_m * off;
    if (length_of(before + off) < 0.1) {
      const Triple<double>& beside = face == "pressure" || face == "suction" ? across : upwind;
      leg.waypoints.push_back({(is_out ? root : tip) + stand_off_m * (beside - off), 0, 0});
    }
    before = off;
    leg.waypoints.push_back({is_out ? root : tip, 0, 0});
    leg.waypoints.push_back({is_out ? tip : root, 0, 0});
    is_out = !is_out;
  }
  return {leg};
}

std::vector<WorkLeg> lay_cable(const Config& work, const WorkSite& site, const WorkTurbine& turbine,
                               const Intensity& intensity) {
  const WorkCable& cable = cable_of_site(work, site, turbine);
  const int all = work.optional_integer("lines", 1, 100).value_or(1);
  const double width_m = all > 1 ? (all - 1) * work.number("spacing_m", {0.5, 500}) : 0;
  const int lines = passes_at(all, intensity.density);
  const double spacing_m = lines > 1 ? width_m / (lines - 1) : 0;
  const double at = read_level(work.child("at"), turbine);
  const double off_ends_m =
      work.optional_number("off_ends_m", {0, 500}).value_or(usual::off_ends_m);
  WorkLeg leg;
  bool is_out = false;
  for (const int line : flown_order(lines, intensity.order)) {
    is_out = !is_out;
    const double right_m = (line - 0.5 * (lines - 1)) * spacing_m;
    std::vector<Waypoint> points;
    const auto& route = cable.route_m;
    for (std::size_t i = 0; i < route.size(); ++i) {
      const Triple<double> way =
          i + 1 < route.size() ? route[i + 1] - route[i] : route[i] - route[i - 1];
      const double length_m = std::hypot(way.x, way.y);
      const double n = way.x / length_m, e = way.y / length_m;
      // Not up to the foundations themselves.
      const double ahead_m = i == 0 ? off_ends_m : i + 1 == route.size() ? -off_ends_m : 0;
      points.push_back(
          {{route[i].x + ahead_m * n - right_m * e, route[i].y + ahead_m * e + right_m * n, at},
           0,
           0});
    }
    if (!is_out) std::reverse(points.begin(), points.end());
    leg.waypoints.insert(leg.waypoints.end(), points.begin(), points.end());
  }
  return {leg};
}

std::vector<WorkLeg> lay_mooring(const Config& work, const WorkTurbine& turbine) {
  const std::string id = work.text("mooring");
  const auto found = std::find_if(turbine.moorings.begin(), turbine.moorings.end(),
                                  [&](const MooringLine& line) { return line.id == id; });
  if (found == turbine.moorings.end())
    work.refuse("mooring", "found " + id + ", which turbine " + turbine.id + " does not have");
  const double stand_off_m = read_stand_off(work);
  const double reach = work.optional_number("share", {0.05, 1}).value_or(1);
  const Triple<double> way = found->anchor_m - found->fairlead_m;
  const double length_m = std::hypot(way.x, way.y);
  const Triple<double> aside{-stand_off_m * way.y / length_m, stand_off_m * way.x / length_m, 0};
  const int sides = work.optional_integer("sides", 1, 2).value_or(1);
  constexpr int parts = 12;
  const auto along = [&](int part, const Triple<double>& off_m) {
    Triple<double> at = found->fairlead_m + (reach * part / parts) * way + off_m;
    at.z = std::min(at.z, turbine.bed_m - 1.5);
    return Waypoint{at, 0, 0};
  };
  WorkLeg out, back;
  for (int i = 0; i <= parts; ++i) out.waypoints.push_back(along(i, aside));
  if (sides == 2) back.waypoints.push_back(along(parts, {0, 0, -stand_off_m}));
  for (int i = parts; i >= 0; --i)
    back.waypoints.push_back(along(i, sides == 2 ? -1.0 * aside : aside));
  return {out, back};
}

std::vector<WorkLeg> lay_landing(const Config& work, const WorkTurbine& turbine) {
  const double out_m =
      turbine.radius_m + work.number("gap_m", {0.2, 100}) + work.number("bow_m", {0, 200});
  WorkLeg leg;
  // Speeds of an approach, estimates: the craft has to lose its way.
  leg.waypoints.push_back({turbine.around(turbine.landing_rad, out_m + 150, 0), 0, 0});
  leg.waypoints.push_back({turbine.around(turbine.landing_rad, out_m + 30, 0), 1.5, 0});
  leg.waypoints.push_back({turbine.around(turbine.landing_rad, out_m, 0), 0.5, 0});
  leg.stay_s = read_seconds(work, "stay", {1, 86400});
  return {leg};
}

std::vector<WorkLeg> lay_square(const Config& work, const WorkTurbine& turbine) {
  const Triple<double> datum =
      turbine.around(read_bearing(work, turbine), work.number("distance_m", {5, 10e3}),
                     read_level(work.child("at"), turbine));
  WorkLeg leg;
  leg.waypoints =
      expanding_square(datum, work.number("leg_m", {1, 5000}), work.integer("legs", 2, 200),
                       work.optional_number("course_deg", {-360, 360}).value_or(0) * degree, 0);
  const std::string frame = work.optional_text("frame").value_or("fixed");
  if (frame != "fixed" && frame != "drifting")
    work.refuse("frame", "found " + frame + ", expected fixed or drifting");
  leg.drifts = frame == "drifting";
  return {leg};
}

}  // namespace

double read_level(const Config& level, const WorkTurbine& turbine) {
  constexpr Range range{0, 12000};
  std::optional<double> down;
  std::string named;
  const auto take = [&](const char* key, double sign, double from) {
    const auto value = level.optional_number(key, range);
    if (!value) return;
    if (down) level.refuse(key, "found beside " + named + "; give one of them");
    named = key;
    down = from + sign * *value;
  };
  take("depth_m", 1, 0);
  take("height_m", -1, 0);
  take("above_bed_m", -1, turbine.foot_m);
  take("below_top_m", 1, turbine.top_m);
  if (level.has("below_hub_m")) take("below_hub_m", 1, hub_of(level, "below_hub_m", turbine));
  if (!down)
    level.refuse("depth_m",
                 "missing; give depth_m, height_m, above_bed_m, below_top_m or below_hub_m");
  return *down;
}

std::vector<WorkLeg> lay_out(const Config& work, const WorkSite& site, const WorkTurbine& turbine,
                             const Intensity& intensity) {
  const std::string pattern = work.text("pattern");
  if (pattern == "rings") return lay_rings(work, turbine, intensity);
  if (pattern == "verticals") return lay_verticals(work, turbine, intensity);
  if (pattern == "circles") return lay_circles(work, turbine);
  if (pattern == "blade") return lay_blade(work, turbine, intensity);
  if (pattern == "cable") return lay_cable(work, site, turbine, intensity);
  if (pattern == "mooring") return lay_mooring(work, turbine);
  if (pattern == "bands") return lay_bands(work, turbine, intensity);
  if (pattern == "landing") return lay_landing(work, turbine);
  if (pattern == "square") return lay_square(work, turbine);
  work.refuse("pattern", "found " + pattern +
                             ", expected rings, verticals, circles, blade, cable, mooring, bands, "
                             "landing or square");
}

}  // namespace slackwater::twin
