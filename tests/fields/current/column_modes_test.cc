#include "fields/current/column_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "fields/current/coriolis.h"
#include "fields/current/mixed_layer.h"

namespace slackwater::column_modes_test {
namespace {

constexpr double rho = constants::sea_water_density_kg_m3;

std::vector<ColumnMode<double>> modes_of(double viscosity, double friction, double layer_m,
                                         double coriolis_rad_s) {
  return column_modes(viscosity, friction, layer_m, coriolis_rad_s, [](double x) { return x; });
}

/// A mode by the textbook formula, whatever it forgets in.
struct Mode {
  double wavenumber_1_m;
  Horizontal per_pascal;
};
Mode by_formula(int n, double viscosity, double friction, double layer_m, double coriolis_rad_s) {
  const double x = mode_root(n, friction * layer_m / viscosity);
  const double k = x / layer_m;
  const double norm_m = 0.5 * layer_m * (1 + std::sin(2 * x) / (2 * x));
  return {k, 1.0 / (rho * norm_m * Horizontal(viscosity * k * k, coriolis_rad_s))};
}

TEST(ModeRoot, SolvesItsConditionToRoundingForHugeAndTinyBiotNumbers) {
  for (double biot = 1e-14; biot < 1e13; biot *= 10) {
    for (int n = 0; n < most_column_modes; ++n) {
      const double x = mode_root(n, biot);
      EXPECT_GE(x, n * constants::pi);
      EXPECT_LE(x, (n + 0.5) * constants::pi);
      const double miss = x * std::sin(x) - biot * std::cos(x);
      const double slope = std::sin(x) + x * std::cos(x) + biot * std::sin(x);
      // Newton's correction is what the root is wrong by: a few units of its last place.
      EXPECT_LT(std::abs(miss / slope), 16 * std::numeric_limits<double>::epsilon() * x)
          << "biot " << biot << " n " << n;
    }
  }
}

TEST(ModeRoot, HasTheLimitsOfASlabAndOfNoSlip) {
  // x tan x = b: x^2 = b (1 - b/3) for small b; x = (n + 1/2) pi b/(1 + b) for large b.
  EXPECT_NEAR(mode_root(0, 1e-6) * mode_root(0, 1e-6) / 1e-6, 1 - 1e-6 / 3, 1e-12);
  for (int n = 0; n < 5; ++n)
    EXPECT_NEAR(mode_root(n, 1e8) / ((n + 0.5) * constants::pi), 1e8 / (1 + 1e8), 1e-14);
}

TEST(ModeRoot, IncreasesWithTheBiotNumber) {
  for (int n = 0; n < 8; ++n) {
    double before = 0;
    for (double biot = 1e-6; biot < 1e6; biot *= 1.7) {
      EXPECT_GT(mode_root(n, biot), before);
      before = mode_root(n, biot);
    }
  }
}

TEST(ColumnModes, AreThoseOfTheFormulaDownToWhatForgetsWithinFiveMinutes) {
  const double f = coriolis_parameter_rad_s(Angle::from_degrees(-43));
  const auto modes = modes_of(0.02, 8e-4, 60, f);
  ASSERT_GT(modes.size(), 4u);
  for (std::size_t n = 0; n < modes.size(); ++n) {
    const Horizontal expected = by_formula(static_cast<int>(n), 0.02, 8e-4, 60, f).per_pascal;
    EXPECT_LT(std::abs(to_horizontal(modes[n].per_pascal) - expected), 1e-14 * std::abs(expected));
    EXPECT_LE(modes[n].decay_1_s.re, instant_1_s);
    EXPECT_EQ(modes[n].decay_1_s.im, f);
  }
  const double next = mode_root(static_cast<int>(modes.size()), 8e-4 * 60 / 0.02) / 60;
  EXPECT_GT(0.02 * next * next, instant_1_s);
}

TEST(ColumnModes, TheGravestIsThereHoweverQuicklyItForgets) {
  EXPECT_EQ(modes_of(1.0, 2e-2, 1.0, 1e-4).size(), 1u);
  EXPECT_EQ(modes_of(1e-4, 1e-5, 5000, 1e-4).size(), static_cast<std::size_t>(most_column_modes));
}

TEST(ColumnModes, SumToTheSteadyAnswerOfTheWaterColumnAndOfTheMixedLayer) {
  constexpr int count = 5000;
  for (const double latitude : {50.0, -12.0}) {
    const double f = coriolis_parameter_rad_s(Angle::from_degrees(latitude));
    for (const double friction : {1e-6, 5e-4, 2e-2}) {
      for (const double viscosity : {0.003, 0.1}) {
        const double layer_m = 35;
        const auto finite =
            FiniteDepthColumn<double>::linear_bottom_stress(viscosity, friction, f, rho, layer_m);
        const MixedLayerColumn<double> mixed(viscosity, friction, layer_m, f, rho);
        const std::vector<double> depths{0.0, 3.0, 17.0, 35.0};
        std::vector<Horizontal> sum(depths.size());
        for (int n = 0; n < count; ++n) {
          const Mode mode = by_formula(n, viscosity, friction, layer_m, f);
          for (std::size_t k = 0; k < depths.size(); ++k)
            sum[k] += mode.per_pascal * std::cos(mode.wavenumber_1_m * depths[k]);
        }
        // What lies beyond N modes: 2h/(rho nu pi^2 N) at the surface, less below.
        const double tail = 2 * layer_m / (rho * viscosity * 9.8 * count);
        for (std::size_t k = 0; k < depths.size(); ++k) {
          EXPECT_LT(std::abs(sum[k] - to_horizontal(finite.at_depth(depths[k]).stress)),
                    1.05 * tail);
          EXPECT_LT(std::abs(sum[k] - to_horizontal(mixed.at_depth(depths[k]).stress)),
                    1.05 * tail);
        }
      }
    }
  }
}

}  // namespace
}  // namespace slackwater::column_modes_test
