#include "fields/wind/wake.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/wind/rotor_disc.h"

namespace slackwater::wake_test {
namespace {

constexpr double d_m = 126.0;
constexpr double hub_m = 90.0;
constexpr double pi = constants::pi;
constexpr double area_m2 = pi * d_m * d_m / 4;
const std::vector<WakeModel> all_models{WakeModel::jensen, WakeModel::gaussian, WakeModel::larsen,
                                        WakeModel::blended};

Wake wake_of(WakeModel model, double ct, double ti = 0.08) {
  return make_wake({.model = model}, d_m, hub_m, ct, ti);
}
double edge_m(const Wake& wake, double x_m) {
  return std::visit([&](const auto& w) { return w.edge_m(x_m); }, wake);
}
double reach_m(const Wake& wake, double x_m) {
  return std::visit([&](const auto& w) { return w.reach_m(x_m); }, wake);
}

/// The integral of weight(deficit) over the cross-section, by the midpoints of fine rings.
template <typename Weight>
double over_section(const Wake& wake, double x_m, Weight weight) {
  double total = 0;
  constexpr double step = 0.02;
  for (double r = step / 2; r < 12 * d_m; r += step)
    total += 2 * pi * r * step * weight(wake_deficit(wake, x_m, r));
  return total;
}

TEST(Wake, HasThePublishedDeficitsOnItsAxis) {
  // fields/docs/physics.md, section 10.
  struct Row {
    double x, jensen, gaussian, larsen, added;
  };
  const WakeSettings gaussian{.model = WakeModel::gaussian, .gaussian_growth = 0.0324555};
  for (const Row& row : {Row{3, 0.359512, 0.561971, 0.273335, 0.16221},
                         Row{5, 0.282034, 0.348816, 0.202725, 0.13774},
                         Row{7, 0.227148, 0.245787, 0.165048, 0.12368},
                         Row{10, 0.170613, 0.162346, 0.132005, 0.11034}}) {
    const double x = row.x * d_m;
    EXPECT_NEAR(wake_deficit(wake_of(WakeModel::jensen, 0.8), x, 0), row.jensen, 1e-6);
    EXPECT_NEAR(wake_deficit(make_wake(gaussian, d_m, hub_m, 0.8, 0.08), x, 0), row.gaussian, 1e-6);
    EXPECT_NEAR(wake_deficit(wake_of(WakeModel::larsen, 0.8), x, 0), row.larsen, 1e-6);
    EXPECT_NEAR(added_turbulence(0.8, 0.08, row.x), row.added, 1e-5);
  }
  EXPECT_NEAR(edge_m(wake_of(WakeModel::larsen, 0.8), 7 * d_m), 193.409, 1e-3);
  EXPECT_NEAR(wake_growth(0.075), 0.3837 * 0.075 + 0.003678, 1e-15);
}

TEST(JensenWake, IsADiscOfOneDeficit) {
  const Wake wake = wake_of(WakeModel::jensen, 0.8);
  const double edge = 0.5 * d_m + 0.04 * 5 * d_m;
  EXPECT_EQ(wake_deficit(wake, 5 * d_m, edge - 0.01), wake_deficit(wake, 5 * d_m, 0));
  EXPECT_EQ(wake_deficit(wake, 5 * d_m, edge + 0.01), 0);
}

TEST(LarsenWake, IsThePrintedFormulaAtAnyRadius) {
  // The code has it as axis value times [1 - (r/R_w)^1.5]^2; here as it is printed.
  for (const double ct : {0.1, 0.5, 0.8, 0.95})
    for (const double ti : {0.05, 0.08, 0.15}) {
      const double kl = std::sqrt((1 / std::sqrt(1 - ct) + 1) / 2);
      const double r96 = 0.435449861 *
                         std::exp(0.797853685 * ct * ct - 0.124807893 * ct + 0.136821858) *
                         (15.6298 * ti + 1) * d_m;
      const double x0 = 9.6 * d_m / (std::pow(2 * r96 / (kl * d_m), 3) - 1);
      const double c1 = std::pow(kl * d_m / 2, 2.5) * std::pow(105 / (2 * pi), -0.5) *
                        std::pow(ct * area_m2 * x0, -5.0 / 6);
      const Wake wake = wake_of(WakeModel::larsen, ct, ti);
      for (const double x : {1.0, 7.0, 30.0})
        for (const double r : {0.0, 30.0, 80.0}) {
          if (r >= edge_m(wake, x * d_m)) continue;  // the print means the inside of the wake
          const double s = x * d_m + x0;
          const double braces = std::pow(r, 1.5) * std::pow(3 * c1 * c1 * ct * area_m2 * s, -0.5) -
                                std::pow(35 / (2 * pi), 0.3) * std::pow(3 * c1 * c1, -0.2);
          const double printed = std::cbrt(ct * area_m2 / (s * s)) * braces * braces / 9;
          EXPECT_NEAR(wake_deficit(wake, x * d_m, r), printed, 1e-12) << ct << " " << x << " " << r;
        }
    }
}

TEST(LarsenWake, CarriesTheThrustToFirstOrder) {
  for (const double ct : {0.2, 0.8}) {
    const Wake wake = wake_of(WakeModel::larsen, ct);
    for (const double x : {3.0, 12.0}) {
      EXPECT_NEAR(over_section(wake, x * d_m, [](double u) { return u; }) / (0.5 * ct * area_m2), 1,
                  2e-5);
    }
  }
}

TEST(LarsenWake, IsANumberWhereItsAnchorIsNarrowerThanTheRotor) {
  for (const double ct : {1e-4, 0.5, 0.999})
    for (const LarsenRadius radius : {LarsenRadius::risoe_2009, LarsenRadius::ewts_1996}) {
      const Wake wake =
          make_wake({.model = WakeModel::larsen, .larsen_radius = radius}, d_m, hub_m, ct, 0.0);
      const double deficit = wake_deficit(wake, 5 * d_m, 0);
      EXPECT_TRUE(std::isfinite(deficit) && deficit > 0) << ct;
    }
}

TEST(GaussianAndBlendedWake, TakeTheThrustOfTheRotorFromTheAir) {
  for (const double ct : {0.05, 0.3, 0.75, 0.8, 0.95})
    for (const double x : {0.1, 1.0, 2.0, 3.5, 5.0, 8.0, 9.6, 15.0, 60.0}) {
      const double asked = 0.5 * ct * area_m2;
      const auto momentum = [](double u) { return (1 - u) * u; };
      EXPECT_NEAR(over_section(wake_of(WakeModel::blended, ct), x * d_m, momentum) / asked, 1, 1e-4)
          << "Ct " << ct << ", x/D " << x;
      if (x < 5) continue;  // a Gaussian is real beyond the near wake alone
      EXPECT_NEAR(over_section(wake_of(WakeModel::gaussian, ct), x * d_m, momentum) / asked, 1,
                  1e-4)
          << "Ct " << ct << ", x/D " << x;
    }
}

TEST(BlendedWake, BeginsAsTheInductionOfAnActuatorDiscInFrandsensWake) {
  const double outflow = std::sqrt(1 - 0.8);
  const double radius = 0.5 * d_m * std::sqrt((1 + outflow) / (2 * outflow));
  const Wake wake = wake_of(WakeModel::blended, 0.8);
  EXPECT_NEAR(wake_deficit(wake, 1e-6, 0.99 * radius), 1 - outflow, 1e-12);
  EXPECT_NEAR(wake_deficit(wake, 1e-6, 1.01 * radius), 0, 1e-12);
}

TEST(BlendedWake, HasNoJumpDownstreamAndNeverNarrows) {
  for (const double ct : {0.1, 0.6, 0.8, 0.97})
    for (const double ti : {0.02, 0.08, 0.2}) {
      const Wake wake = wake_of(WakeModel::blended, ct, ti);
      // Behind the core, where a width is one: the edge only grows.
      const double from = blended_wake_shape(ct, ti).near_wake_length * d_m;
      constexpr double step = 0.25;
      for (double x = 1; x < 25 * d_m; x += step) {
        for (const double r : {0.0, 40.0, 100.0}) {
          // The edge of the near wake passes a radius with less than 0.04 per metre.
          ASSERT_NEAR(wake_deficit(wake, x + step, r), wake_deficit(wake, x, r), 0.04 * step)
              << ct << " " << ti << " " << x;
        }
        if (x > from) {
          ASSERT_GE(edge_m(wake, x + step), edge_m(wake, x)) << ct << " " << ti;
          ASSERT_LE(wake_deficit(wake, x + step, 0), wake_deficit(wake, x, 0));
        }
      }
    }
}

TEST(BlendedWake, JoinsTwoModelsThatAgreeWhereTheyMeet) {
  // Width of the Gaussian with Larsen's flux and edge: 0.35857 R_w. Independent fits, 9.6 D.
  for (const double ti : {0.05, 0.08, 0.12}) {
    const double larsen = 0.35857 * edge_m(wake_of(WakeModel::larsen, 0.75, ti), 9.6 * d_m);
    const double blended = 0.5 * edge_m(wake_of(WakeModel::blended, 0.75, ti), 9.6 * d_m);
    EXPECT_NEAR(blended / larsen, 1, 0.08) << ti;
  }
}

TEST(BlendedWake, GrowsAsTheCubeRootOfDistanceInTheEnd) {
  const Wake wake = wake_of(WakeModel::blended, 0.8);
  EXPECT_NEAR(edge_m(wake, 8e5 * d_m) / edge_m(wake, 1e5 * d_m), 2, 1e-3);
}

TEST(Wake, EndsWithinItsReach) {
  for (const WakeModel model : all_models)
    for (const double ct : {0.05, 0.5, 0.8, 0.97})
      for (const double ti : {0.03, 0.08, 0.2}) {
        const Wake wake = wake_of(model, ct, ti);
        for (const double x : {0.01, 0.5, 2.0, 6.0, 9.6, 20.0, 100.0}) {
          EXPECT_LT(wake_deficit(wake, x * d_m, reach_m(wake, x * d_m) * (1 + 1e-9)), 2e-8)
              << static_cast<int>(model) << " Ct " << ct << " x/D " << x;
        }
      }
}

TEST(Wake, IsBetweenStillAirAndTheFreeWindForAnyThrust) {
  for (const WakeModel model : all_models)
    for (double ct = 0; ct < 1.2; ct += 0.05)
      for (const double x : {0.2, 1.5, 4.0, 12.0})
        for (const double r : {0.0, 0.4, 1.0, 3.0}) {
          const double deficit = wake_deficit(wake_of(model, ct), x * d_m, r * d_m);
          EXPECT_TRUE(deficit >= 0 && deficit <= 1)
              << static_cast<int>(model) << " Ct " << ct << " x/D " << x << ": " << deficit;
        }
}

TEST(Wake, IsOnlyBehindARotorThatTurns) {
  for (const WakeModel model : all_models) {
    EXPECT_EQ(wake_deficit(wake_of(model, 0.8), 0, 0), 0);
    EXPECT_EQ(wake_deficit(wake_of(model, 0.8), -100, 0), 0);
    EXPECT_EQ(wake_deficit(wake_of(model, 0), 500, 0), 0);
  }
  EXPECT_EQ(added_turbulence(0, 0.08, 7), 0);
  EXPECT_THROW(wake_of(WakeModel::larsen, 0.8, 8.0), ContractViolation);
}

TEST(DiscRule, IsExactToTheSeventhDegree) {
  // Mean of x^(2a) y^(2b) over the unit disc: (2a-1)!! (2b-1)!! / [2^(a+b) (a+b+1)!].
  const DiscRule rule = disc_rule();
  const auto mean = [&](int a, int b) {
    double total = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i)
      total +=
          rule.weights[i] * std::pow(rule.points[i].across, a) * std::pow(rule.points[i].up, b);
    return total;
  };
  EXPECT_NEAR(mean(0, 0), 1, 1e-14);
  EXPECT_NEAR(mean(2, 0), 1.0 / 4, 1e-14);
  EXPECT_NEAR(mean(0, 4), 3.0 / 24, 1e-14);
  EXPECT_NEAR(mean(2, 2), 1.0 / 24, 1e-14);
  EXPECT_NEAR(mean(6, 0), 15.0 / 192, 1e-14);
  EXPECT_NEAR(mean(4, 2), 3.0 / 192, 1e-14);
  EXPECT_NEAR(mean(3, 2), 0, 1e-14);
}

TEST(DiscRule, AveragesAGaussianWakeOverADiscOnItsAxis) {
  // Mean of exp(-r^2/2s^2) over a disc of radius R: 2 s^2/R^2 [1 - exp(-R^2/2s^2)].
  const DiscRule rule = disc_rule();
  for (const double s : {0.7, 1.0, 2.0}) {
    double total = 0;
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double r = std::hypot(rule.points[i].across, rule.points[i].up);
      total += rule.weights[i] * std::exp(-0.5 * r * r / (s * s));
    }
    EXPECT_NEAR(total, 2 * s * s * (1 - std::exp(-0.5 / (s * s))), 1e-6) << s;
  }
}

}  // namespace
}  // namespace slackwater::wake_test
