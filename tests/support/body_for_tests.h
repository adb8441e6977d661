#pragma once
#include "fields/base/numbers/random.h"
#include "twin/body/body.h"
#include "twin/body/mass_matrix.h"

namespace slackwater::tests {

/// Added masses and dampings of a made-up body, in the order u v w p q r.
struct MadeUpHull {
  std::array<double, 6> added{6, 9, 15, 0.2, 0.3, 0.25};
  std::array<double, 6> linear{};
  std::array<double, 6> quadratic{};
  double mass_kg = 13;
  double displaced_mass_kg = 13;
  twin::Triple<double> centre_of_gravity_m{};
  twin::Triple<double> centre_of_buoyancy_m{};
};

inline twin::Body body_of(const MadeUpHull& hull) {
  constexpr double water = 1025;
  twin::Body body;
  body.mass_kg = hull.mass_kg;
  body.centre_of_gravity_m = hull.centre_of_gravity_m;
  body.fluid_density_kg_m3 = water;
  body.displaced_volume_m3 = hull.displaced_mass_kg / water;
  body.centre_of_buoyancy_m = hull.centre_of_buoyancy_m;
  body.height_m = 0.3;
  body.rigid_mass = twin::rigid_mass_matrix(hull.mass_kg, {0.26, 0.23, 0.37, 0.01, -0.02, 0.015},
                                            hull.centre_of_gravity_m);
  for (std::size_t i = 0; i < 6; ++i) body.added_mass.entry[i][i] = hull.added[i];
  body.inverse_mass = twin::inverse_of(twin::sum_of(body.rigid_mass, body.added_mass)).value();
  const auto diagonal = [](const std::array<double, 6>& d) {
    return twin::Spatial<double>{{d[0], d[1], d[2]}, {d[3], d[4], d[5]}};
  };
  body.linear_damping = diagonal(hull.linear);
  body.quadratic_damping = diagonal(hull.quadratic);
  return body;
}

/// Deep in still water, level, heading north, at rest.
inline twin::BodyState<double> at_rest() {
  twin::BodyState<double> state;
  state.position_m.z = 50;
  state.attitude.w = 1;
  return state;
}

inline twin::Triple<double> random_triple(Rng& random, double scale = 1) {
  return {scale * random.normal(), scale * random.normal(), scale * random.normal()};
}

}  // namespace slackwater::tests
