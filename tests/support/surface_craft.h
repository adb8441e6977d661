#pragma once
#include <cmath>
#include <string>
#include <vector>

#include "tests/support/shared_data.h"
#include "twin/body/body_dynamics.h"
#include "twin/vehicle/read_body.h"

namespace slackwater::tests {

inline twin::Body body_of(const std::string& id) {
  return twin::read_body(Config::load(source_folder() / "data/vehicles" / (id + ".yaml")));
}

/// At rest in still water, heading north.
inline twin::BodyState<double> afloat(const twin::Body& body) {
  twin::BodyState<double> state;
  state.attitude.w = 1;
  state.position_m.z = twin::floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3);
  return state;
}

/// What hangs on the form of a hull below its waterline, from the closed form of its section.
struct Waterline {
  double draught_m = 0;
  double breadth_m = 0;
  double area_m2 = 0;
  double centre_m = 0;  ///< of the area, above the keel
};

/// A circle of a radius that lies in the water up to a draught.
inline Waterline of_circle(double radius_m, double draught_m) {
  const double half_angle = std::acos(1 - draught_m / radius_m);
  const double half_chord = radius_m * std::sin(half_angle);
  const double area =
      radius_m * radius_m * (half_angle - std::sin(half_angle) * std::cos(half_angle));
  return {draught_m, 2 * half_chord, area, radius_m - 2 * std::pow(half_chord, 3) / (3 * area)};
}

/// A V of a deadrise.
inline Waterline of_wedge(double deadrise_deg, double draught_m) {
  const double breadth = 2 * draught_m / std::tan(deadrise_deg * constants::pi / 180);
  return {draught_m, breadth, 0.5 * breadth * draught_m, 2 * draught_m / 3};
}

/// A twin hull of one section from end to end, as the textbooks have it.
struct TwinHull {
  double length_m = 0;
  double half_spacing_m = 0;
  Waterline at_rest;

  [[nodiscard]] double heave_n_m() const { return water_n_m3() * 2 * length_m * at_rest.breadth_m; }
  /// W GM = rho g I - W (KG - KB), N m/rad.
  [[nodiscard]] double roll_n_m(double height_of_gravity_m) const {
    const double b = at_rest.breadth_m;
    return water_n_m3() * 2 * length_m * (b * half_spacing_m * half_spacing_m + b * b * b / 12) -
           weight_n() * (height_of_gravity_m - at_rest.centre_m);
  }
  [[nodiscard]] double pitch_n_m(double height_of_gravity_m) const {
    return water_n_m3() * 2 * at_rest.breadth_m * std::pow(length_m, 3) / 12 -
           weight_n() * (height_of_gravity_m - at_rest.centre_m);
  }
  [[nodiscard]] double weight_n() const { return water_n_m3() * 2 * length_m * at_rest.area_m2; }
  [[nodiscard]] static double water_n_m3() {
    return constants::sea_water_density_kg_m3 * constants::gravity_m_s2;
  }
};

}  // namespace slackwater::tests
