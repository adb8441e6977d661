#include "twin/body/floating_hull.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

/// How wide the section is at a height above its keel.
struct Shape {
  double radius_m = 0;  ///< of a cylinder; else a box on a V
  double beam_m = 0;
  double depth_m = 0;
  double rise_m = 0;  ///< of the V, from keel to chine

  [[nodiscard]] double width_m(double height_m) const {
    if (radius_m > 0) {
      const double up = height_m - radius_m;
      return 2 * std::sqrt(std::max(0.0, radius_m * radius_m - up * up));
    }
    return rise_m > 0 && height_m < rise_m ? beam_m * height_m / rise_m : beam_m;
  }
};

Shape read_shape(const Config& c) {
  Shape shape;
  if (const auto radius = c.optional_number("radius_m", {0.02, 20})) {
    shape.radius_m = *radius;
    shape.depth_m = 2 * *radius;
    return shape;
  }
  shape.beam_m = c.number("beam_m", {0.05, 40});
  shape.depth_m = c.number("depth_m", {0.05, 30});
  const double deadrise = c.optional_number("deadrise_deg", {0, 85}).value_or(0);
  shape.rise_m = 0.5 * shape.beam_m * std::tan(deadrise * constants::pi / 180);
  if (shape.rise_m > shape.depth_m) {
    c.refuse("deadrise_deg", "the V of the bottom reaches over the deck; check beam_m and depth_m");
  }
  return shape;
}

/// By the midpoint rule on many slices, so that the table is exact to what its own linear steps
/// are.
void tabulate(const Shape& shape, HullPart& part) {
  constexpr int slices = 200;  // between two points of the table
  part.section_depth_m = shape.depth_m;
  const double step = shape.depth_m / (section_points - 1);
  double area = 0;
  double moment = 0;
  for (std::size_t i = 1; i < section_points; ++i) {
    for (int s = 0; s < slices; ++s) {
      const double height = step * (static_cast<double>(i - 1) + (s + 0.5) / slices);
      const double slice = shape.width_m(height) * step / slices;
      area += slice;
      moment += slice * height;
    }
    part.section[i].area_m2 = area;
    part.section[i].moment_m3 = moment;
  }
  for (std::size_t i = 0; i < section_points; ++i) {
    const double breadth = shape.width_m(step * static_cast<double>(i));
    part.section[i].breadth_m = breadth;
    part.section[i].second_moment_m3 = breadth * breadth * breadth / 12;
  }
}

/// All strips alike.
void measure_spread(FloatingHull& hull) {
  const auto strips = static_cast<double>(hull.strips);
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.share[i] = 1.0 / strips;
    hull.middle_m.x += hull.keel_m[i].x / strips;
    hull.middle_m.y += hull.keel_m[i].y / strips;
  }
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.spread_x_m2 += std::pow(hull.keel_m[i].x - hull.middle_m.x, 2) / strips;
    hull.spread_y_m2 += std::pow(hull.keel_m[i].y - hull.middle_m.y, 2) / strips;
  }
}

/// By the area of the waterline at each strip.
void measure_spread_by_area(FloatingHull& hull, double down_m) {
  double all_m2 = 0;
  for (std::size_t p = 0; p < hull.parts; ++p) {
    const HullPart& part = hull.part[p];
    for (std::size_t i = part.first; i < part.first + part.strips; ++i) {
      const double draught_m = std::min(down_m + hull.keel_m[i].z, part.section_depth_m);
      hull.share[i] =
          draught_m > 0 ? part.strip_length_m * section_at(part, draught_m).breadth_m : 0;
      all_m2 += hull.share[i];
    }
  }
  if (!(all_m2 > 0)) return;
  hull.middle_m = {};
  hull.spread_x_m2 = hull.spread_y_m2 = 0;
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.share[i] /= all_m2;
    hull.middle_m.x += hull.share[i] * hull.keel_m[i].x;
    hull.middle_m.y += hull.share[i] * hull.keel_m[i].y;
  }
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.spread_x_m2 += hull.share[i] * std::pow(hull.keel_m[i].x - hull.middle_m.x, 2);
    hull.spread_y_m2 += hull.share[i] * std::pow(hull.keel_m[i].y - hull.middle_m.y, 2);
  }
}

void read_part(const Config& c, FloatingHull& hull) {
  HullPart& part = hull.part[hull.parts++];
  tabulate(read_shape(c), part);
  const double from = c.number("from_x_m", {-100, 100});
  const double to = c.number("to_x_m", {-100, 100});
  const double keel_z = c.number("keel_z_m", {-20, 20});
  const std::vector<double> sides = c.numbers("centre_y_m", {-50, 50});
  const auto strips = static_cast<std::size_t>(c.integer("strips", 1, most_strips));
  if (!(to > from)) c.refuse("to_x_m", "expected it forward of from_x_m");
  if (sides.empty() || hull.strips + sides.size() * strips > most_strips) {
    c.refuse("strips", "found " + std::to_string(hull.strips + sides.size() * strips) +
                           " strips over all hulls, expected 1 to " + std::to_string(most_strips));
  }
  part.first = hull.strips;
  part.strips = sides.size() * strips;
  part.strip_length_m = (to - from) / static_cast<double>(strips);
  part.strips_in_row = strips;
  for (const double y : sides) {
    for (std::size_t i = 0; i < strips; ++i)
      hull.keel_m[hull.strips++] = {from + part.strip_length_m * (static_cast<double>(i) + 0.5), y,
                                    keel_z};
  }
}

/// How far above the keel a part feels the waves that floats with its keel this far under water.
double felt_height_m(const HullPart& part, double draught_m) {
  const Section section = section_at(part, draught_m);
  const double mean_draught = section.area_m2 / section.breadth_m;
  return std::max(0.0, draught_m - mean_draught);
}

}  // namespace

FloatingHull read_floating_hull(const Config& vehicle) {
  FloatingHull hull;
  if (vehicle.is_list("hulls")) {
    const std::vector<Config> parts = vehicle.children("hulls");
    if (parts.empty() || parts.size() > most_sections)
      vehicle.refuse("hulls", "found " + std::to_string(parts.size()) +
                                  " hulls of a section each, expected 1 to " +
                                  std::to_string(most_sections));
    for (const Config& part : parts) read_part(part, hull);
  } else if (const auto c = vehicle.optional_child("hulls")) {
    read_part(*c, hull);
  } else {
    return hull;
  }
  measure_spread(hull);
  return hull;
}

double floating_depth_m(const FloatingHull& hull, double mass_kg, double water_density_kg_m3) {
  const double weight_n = mass_kg * constants::gravity_m_s2;
  const Rotation<double> level{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const auto lift_n = [&](double down_m) {
    return -floating_force<double>(hull, water_density_kg_m3, level, down_m, nullptr).linear.z;
  };
  // From the lowest keel at the surface to the first deck in the water.
  double high = std::numeric_limits<double>::infinity();
  double low = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < hull.parts; ++p) {
    const double keel_up_m = -hull.keel_m[hull.part[p].first].z;
    high = std::min(high, keel_up_m);
    low = std::min(low, keel_up_m + hull.part[p].section_depth_m);
  }
  if (lift_n(low) < weight_n) {
    throw Error(
        ErrorKind::invalid_input,
        formatted(
            "the hulls bear {:.0f} kg with the deck in the water and the vehicle has {:.0f} kg: "
            "it sinks; check mass_kg and hulls",
            lift_n(low) / constants::gravity_m_s2, mass_kg));
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (lift_n(middle) < weight_n ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

Section section_at(const HullPart& part, double draught_m) {
  const double place = (section_points - 1) * draught_m / part.section_depth_m;
  const auto low =
      static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(section_points - 2)));
  const double share = place - static_cast<double>(low);
  const Section& a = part.section[low];
  const Section& b = part.section[low + 1];
  const auto between = [&](double x, double y) { return x + share * (y - x); };
  return {between(a.area_m2, b.area_m2), between(a.moment_m3, b.moment_m3),
          between(a.breadth_m, b.breadth_m), between(a.second_moment_m3, b.second_moment_m3)};
}

void settle(FloatingHull& hull, double down_m) {
  if (hull.parts > 1) measure_spread_by_area(hull, down_m);
  for (std::size_t p = 0; p < hull.parts; ++p) {
    HullPart& part = hull.part[p];
    const double draught_m = hull.keel_m[part.first].z + down_m;
    part.felt_height_m = draught_m > 0 ? felt_height_m(part, draught_m) : 0;
  }
}

}  // namespace slackwater::twin
