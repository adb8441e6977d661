#include "twin/vehicle/read_body.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/body/mass_matrix.h"
#include "twin/vehicle/read_cross_flow.h"
#include "twin/vehicle/read_derivatives.h"

namespace slackwater::twin {
namespace {

Triple<double> read_point(const Config& config, std::string_view key,
                          const Triple<double>& absent) {
  const std::vector<double> at = config.numbers(key, {-200, 200});
  if (at.empty()) return absent;
  if (at.size() != 3)
    config.refuse(key, "found " + std::to_string(at.size()) + " numbers; give [x, y, z] in metres");
  return {at[0], at[1], at[2]};
}

struct Dimensions {
  double length = 0;
  double width = 0;
  double height = 0;
};

Dimensions read_dimensions(const Config& vehicle) {
  const Config c = vehicle.child("dimensions_m");
  return {c.number("length", {0.05, 500}), c.number("width", {0.05, 100}),
          c.number("height", {0.02, 100})};
}

void expect_inertia_within(const Config& config, double moment, double mass_kg, double a, double b,
                           std::string_view key) {
  // All mass in the corners of the hull's box.
  const double most = mass_kg * (a * a + b * b) / 4;
  if (moment <= most) return;
  config.refuse(key,
                formatted("found {:g} kg m2; with all its mass at the edge of its hull the vehicle "
                          "would have {:g}. Check the unit and the mass",
                          moment, most));
}

Inertia read_inertia(const Config& rigid, double mass_kg, const Dimensions& d) {
  const Config c = rigid.child("inertia_kg_m2");
  const auto product = [&](const char* key) {
    return c.optional_number(key, {-1e9, 1e9}).value_or(0);
  };
  const Inertia inertia{c.number("xx", {1e-9, 1e9}),
                        c.number("yy", {1e-9, 1e9}),
                        c.number("zz", {1e-9, 1e9}),
                        product("xy"),
                        product("xz"),
                        product("yz")};
  const auto [low, middle, high] = principal_moments(inertia);
  if (!(low > 0))
    c.refuse("xx",
             formatted("the moments of inertia have the principal values {:g} to {:g} kg m2, which "
                       "no mass has; check the products xy, xz, yz",
                       low, high));
  if (high > (low + middle) * (1 + 1e-9))
    c.refuse("xx",
             formatted("the largest principal moment, {:g} kg m2, exceeds the sum of the other "
                       "two, {:g}; no body has such (triangle inequality)",
                       high, low + middle));
  expect_inertia_within(c, inertia.xx, mass_kg, d.width, d.height, "xx");
  expect_inertia_within(c, inertia.yy, mass_kg, d.length, d.height, "yy");
  expect_inertia_within(c, inertia.zz, mass_kg, d.length, d.width, "zz");
  return inertia;
}

void read_displacement(const Config& vehicle, const Dimensions& d, Body& body) {
  const auto c = vehicle.optional_child("displacement");
  if (!c) return;
  body.displaced_volume_m3 = c->number("volume_m3", {1e-6, 1e5});
  body.centre_of_buoyancy_m = read_point(*c, "centre_of_buoyancy_m", {});
  const double box_m3 = d.length * d.width * d.height;
  if (body.displaced_volume_m3 > box_m3)
    c->refuse("volume_m3",
              formatted("found {:g} m3, more than the {:g} m3 of a box around the hull",
                        body.displaced_volume_m3, box_m3));
  const double displaced_kg = body.fluid_density_kg_m3 * body.displaced_volume_m3;
  if (body.mass_kg < 0.5 * displaced_kg || body.mass_kg > 2 * displaced_kg)
    c->refuse("volume_m3",
              formatted("the vehicle has {:g} kg and displaces {:g} kg of water; one "
                        "that swims has about as much as it displaces. Check the units",
                        body.mass_kg, displaced_kg));
}

void read_stations(const Config& vehicle, const Dimensions& d, Body& body) {
  const auto c = vehicle.optional_child("drag_stations");
  if (!c) return;
  body.stations = static_cast<std::size_t>(c->integer("count", 1, most_stations));
  const std::string along = c->text("along");
  if (along != "length" && along != "height")
    c->refuse("along", "found " + along + ", expected length or height");
  for (std::size_t i = 0; i < body.stations; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(body.stations) - 0.5;
    if (along == "length")
      body.station_m[i] = {share * d.length, 0, 0};
    else
      body.station_m[i] = {0, 0, share * d.height};
  }
}

void read_trailing_edge(const Config& vehicle, const Dimensions& d, Body& body) {
  const auto c = vehicle.optional_child("trailing_edge");
  if (!c) return;
  body.trailing_edge_x_m = c->number("position_x_m", {-d.length, 0});
  body.trailing_edge_kg_m = c->number("added_mass_kg_m", {0, 1e6});
}

}  // namespace

Body read_body(const Config& vehicle) {
  Body body;
  const Dimensions d = read_dimensions(vehicle);
  body.height_m = d.height;
  body.radius_m = 0.5 * std::hypot(d.length, d.width);
  const Config rigid = vehicle.child("rigid_body");
  body.mass_kg = rigid.number("mass_kg", {0.01, 1e7});
  body.centre_of_gravity_m = read_point(rigid, "centre_of_gravity_m", {});
  const Inertia inertia = read_inertia(rigid, body.mass_kg, d);
  body.rigid_mass = rigid_mass_matrix(body.mass_kg, inertia, body.centre_of_gravity_m);
  body.fluid_density_kg_m3 = vehicle.optional_number("water_density_kg_m3", {990, 1040})
                                 .value_or(constants::sea_water_density_kg_m3);
  read_displacement(vehicle, d, body);
  body.hull = read_floating_hull(vehicle);
  if (body.hull.strips > 0 && body.displaced_volume_m3 > 0)
    vehicle.refuse(
        "hulls",
        "found displacement beside hulls; a craft floats on the one or is filled by the other");
  if (body.hull.strips > 0)
    settle(body.hull, floating_depth_m(body.hull, body.mass_kg, body.fluid_density_kg_m3));
  body.added_mass = read_added_mass(vehicle);
  read_damping(vehicle, body);
  read_stations(vehicle, d, body);
  read_trailing_edge(vehicle, d, body);
  read_lift(vehicle, body);
  read_cross_flow(vehicle, d.length, body);
  const auto inverse = inverse_of(sum_of(body.rigid_mass, body.added_mass));
  if (!inverse) {
    vehicle.refuse("rigid_body",
                   "the mass matrix with the added mass is not positive definite: the vehicle "
                   "would gain energy by being slowed; check centre_of_gravity_m, the inertia and "
                   "added_mass");
  }
  body.inverse_mass = *inverse;
  return body;
}

}  // namespace slackwater::twin
