#include "api/made_up/synthetic/wind_driven_column.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/constants.h"
#include "tests/support/crank_nicolson_column.h"

namespace slackwater::api::wind_driven_column_test {
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
  const ColumnMixing mixing = physics().at_depth(35);
  CrankNicolsonColumn cells(35, 350, mixing.eddy_viscosity_m2_s, mixing.bottom_friction_m_s,
                            physics().coriolis_rad_s, 60);
  for (int minute = 0; minute < 40 * 60; ++minute) cells.step(stress((minute + 0.5) / 60), 0);
  for (const double depth_m : {0.55, 5.05, 12.05, 25.05, 34.05}) {
    // 0.2 mm/s: second order in 0.1 m cells, 10 min of piecewise linear stress.
    EXPECT_LT(std::abs(column.velocity(35, depth_m, 40) - cells.at_depth(depth_m)), 2e-4)
        << depth_m;
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
}  // namespace slackwater::api::wind_driven_column_test
