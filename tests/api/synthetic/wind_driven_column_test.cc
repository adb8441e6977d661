#include "api/synthetic/wind_driven_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr Horizontal imaginary{0, 1};

ColumnPhysics physics() {
  return {.coriolis_rad_s = 1.098e-4,
          .reference_depth_m = 35,
          .reference = {.eddy_viscosity_m2_s = 0.02, .bottom_friction_m_s = 1.2e-3}};
}

/// Linear bottom stress, no interior: fields/docs/physics.md section 4 with W_g = 0; T is
/// kinematic.
Horizontal closed_form(const ColumnPhysics& p, double depth_m, double water_m, Horizontal stress) {
  const ColumnMixing mixing = p.at_depth(water_m);
  const double nu = mixing.eddy_viscosity_m2_s;
  const double r = mixing.bottom_friction_m_s;
  const Horizontal lambda = std::sqrt(imaginary * p.coriolis_rad_s / nu);
  const Horizontal scale = stress / (nu * lambda);
  const Horizontal a =
      (nu * lambda * scale * std::cosh(lambda * water_m) +
       r * scale * std::sinh(lambda * water_m)) /
      (r * std::cosh(lambda * water_m) + nu * lambda * std::sinh(lambda * water_m));
  // A W_z = F at the top and A W_z = r W at the bed hold for W = P sinh(lambda z) + A cosh(lambda
  // z).
  return scale * std::sinh(-lambda * depth_m) + a * std::cosh(lambda * depth_m);
}

/// The same column by finite volumes in depth and Crank-Nicolson in time: slow, simple, and nothing
/// shared.
std::vector<Horizontal> crank_nicolson(const ColumnPhysics& p, double water_m, double hours,
                                       const std::function<Horizontal(double)>& stress) {
  constexpr std::size_t cells = 350;
  const ColumnMixing mixing = p.at_depth(water_m);
  const double dz = water_m / cells;
  const double dt = 60;
  const double exchange = mixing.eddy_viscosity_m2_s / (dz * dz);
  // Half a cell of viscosity in series with the friction.
  const double drag =
      1 / (1 / mixing.bottom_friction_m_s + 0.5 * dz / mixing.eddy_viscosity_m2_s) / dz;
  std::vector<Horizontal> w(cells);
  std::vector<Horizontal> right(cells);
  std::vector<Horizontal> upper(cells);
  const auto steps = static_cast<int>(hours * 3600 / dt);
  for (int step = 0; step < steps; ++step) {
    const Horizontal forcing = stress((step + 0.5) * dt / 3600) / dz;
    const auto tendency = [&](std::size_t k) {
      Horizontal rate = -imaginary * p.coriolis_rad_s * w[k];
      if (k > 0) rate += exchange * (w[k - 1] - w[k]);
      if (k + 1 < cells) rate += exchange * (w[k + 1] - w[k]);
      if (k + 1 == cells) rate -= drag * w[k];
      return rate;
    };
    for (std::size_t k = 0; k < cells; ++k) {
      right[k] = w[k] + 0.5 * dt * tendency(k) + (k == 0 ? dt * forcing : Horizontal{});
    }
    for (std::size_t k = 0; k < cells; ++k) {  // Thomas
      const double above = k > 0 ? exchange : 0;
      const double below = k + 1 < cells ? exchange : drag;
      Horizontal pivot = 1.0 + 0.5 * dt * (above + below + imaginary * p.coriolis_rad_s);
      const double side = -0.5 * dt * exchange;
      if (k > 0) {
        pivot -= side * upper[k - 1];
        right[k] -= side * right[k - 1];
      }
      upper[k] = k + 1 < cells ? side / pivot : Horizontal{};
      right[k] /= pivot;
    }
    w[cells - 1] = right[cells - 1];
    for (std::size_t k = cells - 1; k-- > 0;) w[k] = right[k] - upper[k] * w[k + 1];
  }
  return w;
}

TEST(WindDrivenColumn, SteadyWindEndsInTheClosedFormOfFiniteDepth) {
  const Horizontal stress{1.2e-4, -0.7e-4};
  const WindDrivenColumn column(physics(), 0, 400, [&](double) { return stress; });
  for (const double depth_m : {0.0, 1.0, 7.3, 20.0, 34.0, 35.0}) {
    // Truncation of the modes, 0.1 mm/s; the inertial oscillation is gone after 400 h.
    EXPECT_LT(
        std::abs(column.velocity(35, depth_m, 390) - closed_form(physics(), depth_m, 35, stress)),
        1e-4)
        << depth_m;
  }
}

TEST(WindDrivenColumn, AgreesWithAFiniteVolumeColumnUnderAVeeringGustyWind) {
  const auto stress = [](double hours) {
    return 1.5e-4 * (1 - std::cos(0.4 * hours)) * std::polar(1.0, 0.07 * hours);
  };
  const WindDrivenColumn column(physics(), 0, 60, stress);
  const std::vector<Horizontal> cells = crank_nicolson(physics(), 35, 40, stress);
  for (const std::size_t k : {5U, 50U, 120U, 250U, 340U}) {
    const double depth_m = (static_cast<double>(k) + 0.5) * 0.1;
    // 0.2 mm/s: second order in 0.1 m cells, 10 min of piecewise linear stress.
    EXPECT_LT(std::abs(column.velocity(35, depth_m, 40) - cells[k]), 2e-4) << depth_m;
  }
}

TEST(WindDrivenColumn, OtherDepthsFollowFromOneIntegrationExactly) {
  const auto stress = [](double hours) { return 1e-4 * std::polar(1.0, 0.05 * hours); };
  const WindDrivenColumn reference(physics(), 0, 60, stress);
  ColumnPhysics deep = physics();
  deep.reference = deep.at_depth(52);
  deep.reference_depth_m = 52;
  const WindDrivenColumn own(deep, 0, 60, stress);
  for (const double depth_m : {0.0, 13.0, 51.0}) {
    EXPECT_LT(std::abs(reference.velocity(52, depth_m, 50) - own.velocity(52, depth_m, 50)), 1e-12);
  }
}

TEST(WindDrivenColumn, TurningTheStressTurnsTheWholeColumn) {
  const auto stress = [](double hours) {
    return 1e-4 * std::polar(1.0 + 0.3 * std::sin(hours), 0.05 * hours);
  };
  const Horizontal turn = std::polar(1.0, 0.83);
  const WindDrivenColumn before(physics(), 0, 60, stress);
  const WindDrivenColumn after(physics(), 0, 60,
                               [&](double hours) { return turn * stress(hours); });
  for (const double depth_m : {0.0, 9.0, 33.0}) {
    EXPECT_LT(
        std::abs(turn * before.velocity(35, depth_m, 47.3) - after.velocity(35, depth_m, 47.3)),
        1e-14);
  }
}

TEST(BottomLayerFactor, SatisfiesMomentumFrictionAndAFreeSurface) {
  const ColumnPhysics p = physics();
  for (const double sigma : {0.0, 1.405e-4, -1.405e-4, -0.729e-4}) {
    for (const double water_m : {17.0, 35.0, 58.0}) {
      const ColumnMixing mixing = p.at_depth(water_m);
      const auto w = [&](double depth_m) {
        return bottom_layer_factor(p, water_m, depth_m, sigma);
      };
      const double h = 1e-2 * water_m;
      const double middle = 0.6 * water_m;
      const Horizontal curvature = (w(middle + h) - 2.0 * w(middle) + w(middle - h)) / (h * h);
      const Horizontal balance = imaginary * (p.coriolis_rad_s + sigma) * (w(middle) - 1.0);
      EXPECT_LT(std::abs(mixing.eddy_viscosity_m2_s * curvature - balance),
                1e-3 * std::abs(balance));
      const double e = 1e-5 * water_m;
      const Horizontal bed_stress = mixing.eddy_viscosity_m2_s * (w(water_m - e) - w(water_m)) / e;
      EXPECT_LT(std::abs(bed_stress - mixing.bottom_friction_m_s * w(water_m)),
                1e-4 * std::abs(bed_stress));
      EXPECT_LT(std::abs(w(e) - w(0)), 1e-8);
    }
  }
}

}  // namespace
}  // namespace slackwater::api
