#include "twin/body/floating_hull.h"

#include <algorithm>
#include <cmath>

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
  const double deadrise = c.optional_number("deadrise_deg", {0, 60}).value_or(0);
  shape.rise_m = 0.5 * shape.beam_m * std::tan(deadrise * constants::pi / 180);
  if (shape.rise_m > shape.depth_m) {
    c.refuse("deadrise_deg", "the V of the bottom reaches over the deck; check beam_m and depth_m");
  }
  return shape;
}

/// By the midpoint rule on many slices, so that the table is exact to what its own linear steps
/// are.
void tabulate(const Shape& shape, FloatingHull& hull) {
  constexpr int slices = 200;  // between two points of the table
  hull.section_depth_m = shape.depth_m;
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
    hull.section[i].area_m2 = area;
    hull.section[i].moment_m3 = moment;
  }
  for (std::size_t i = 0; i < section_points; ++i) {
    const double breadth = shape.width_m(step * static_cast<double>(i));
    hull.section[i].breadth_m = breadth;
    hull.section[i].second_moment_m3 = breadth * breadth * breadth / 12;
  }
}

void measure_spread(FloatingHull& hull) {
  const auto strips = static_cast<double>(hull.strips);
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.middle_m.x += hull.keel_m[i].x / strips;
    hull.middle_m.y += hull.keel_m[i].y / strips;
  }
  for (std::size_t i = 0; i < hull.strips; ++i) {
    hull.spread_x_m2 += std::pow(hull.keel_m[i].x - hull.middle_m.x, 2) / strips;
    hull.spread_y_m2 += std::pow(hull.keel_m[i].y - hull.middle_m.y, 2) / strips;
  }
}

}  // namespace

FloatingHull read_floating_hull(const Config& vehicle) {
  FloatingHull hull;
  const auto c = vehicle.optional_child("hulls");
  if (!c) return hull;
  tabulate(read_shape(*c), hull);
  const double from = c->number("from_x_m", {-100, 100});
  const double to = c->number("to_x_m", {-100, 100});
  const double keel_z = c->number("keel_z_m", {-20, 20});
  const std::vector<double> sides = c->numbers("centre_y_m", {-50, 50});
  const auto strips = static_cast<std::size_t>(c->integer("strips", 1, most_strips));
  if (!(to > from)) c->refuse("to_x_m", "expected it forward of from_x_m");
  if (sides.empty() || sides.size() * strips > most_strips) {
    c->refuse("strips", "found " + std::to_string(sides.size() * strips) +
                            " strips over all hulls, expected 1 to " + std::to_string(most_strips));
  }
  hull.strip_length_m = (to - from) / static_cast<double>(strips);
  hull.strips_in_row = strips;
  for (const double y : sides) {
    for (std::size_t i = 0; i < strips; ++i)
      hull.keel_m[hull.strips++] = {from + hull.strip_length_m * (static_cast<double>(i) + 0.5), y,
                                    keel_z};
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
  double high = -hull.keel_m[0].z;  // the keel at the surface
  double low = high + hull.section_depth_m;
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

double felt_height_m(const FloatingHull& hull, double draught_m) {
  const double place = (section_points - 1) * draught_m / hull.section_depth_m;
  const auto low = std::min(static_cast<std::size_t>(std::max(0.0, place)), section_points - 2);
  const double share = place - static_cast<double>(low);
  const Section& below = hull.section[low];
  const Section& above = hull.section[low + 1];
  const double area_m2 = below.area_m2 + share * (above.area_m2 - below.area_m2);
  const double breadth_m = below.breadth_m + share * (above.breadth_m - below.breadth_m);
  const double mean_draught = area_m2 / breadth_m;
  return std::max(0.0, draught_m - mean_draught);
}

}  // namespace slackwater::twin
