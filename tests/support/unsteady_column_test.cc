#include "tests/support/unsteady_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/current/coriolis.h"
#include "tests/support/crank_nicolson_column.h"

namespace slackwater::unsteady_column_test {
namespace {

using std::chrono::hours;

const UtcTime start{hours(0)};
constexpr double rho = constants::sea_water_density_kg_m3;

/// A column and what the wind makes in it.
struct Sea {
  SteadyForm form = SteadyForm::finite_depth;
  double latitude_deg = 48.6;
  double water_m = 35;
  SteadyParameters p;

  /// Same viscosity, friction and moving depth whichever the form.
  Sea(SteadyForm given, double latitude, double layer_m, double viscosity, double friction)
      : form(given), latitude_deg(latitude), water_m(layer_m) {
    p.eddy_viscosity_m2_s = viscosity;
    p.bottom_friction_m_s = p.base_friction_m_s = friction;
    p.mixed_layer_depth_m = layer_m;
    p.stress_factor = 1.1;
  }
  [[nodiscard]] Angle latitude() const { return Angle::from_degrees(latitude_deg); }
  [[nodiscard]] double f() const { return coriolis_parameter_rad_s(latitude()); }
  [[nodiscard]] UnsteadyColumn column(const std::vector<double>& depths,
                                      const HourlyStress& stress) const {
    return {form, p, latitude(), water_m, depths, stress};
  }
  [[nodiscard]] LevelResponses steady(const std::vector<double>& depths) const {
    return level_responses(form, p, latitude(), water_m, depths);
  }
  /// The transient h hours after the start.
  [[nodiscard]] std::vector<Horizontal> transient(const std::vector<double>& depths,
                                                  const HourlyStress& stress, double hour) const {
    std::vector<Horizontal> out(depths.size());
    column(depths, stress).transient(TimeCell::instant(add_hours(start, hour)), out);
    return out;
  }
};

const std::vector<SteadyForm> moving_forms{SteadyForm::finite_depth, SteadyForm::mixed_layer};

/// A stress that rises from nothing within the first hour and then stands.
HourlyStress step(Horizontal stress_pa, int last_h) {
  HourlyStress hourly;
  hourly.first = start;
  hourly.stress_pa.assign(static_cast<std::size_t>(last_h) + 1, stress_pa);
  hourly.stress_pa[0] = 0;
  hourly.is_known.assign(hourly.stress_pa.size(), true);
  return hourly;
}

TEST(UnsteadyColumn, AgreesWithAnIndependentIntegrationInTime) {
  // 0.2 m and 60 s leave 0.2 mm/s. A mixed layer moves like a water column of its own depth.
  const std::vector<double> depths{0.1, 8.1, 20.1, 34.9};
  for (const SteadyForm form : moving_forms) {
    for (const double latitude : {48.6, -35.0}) {
      Sea sea(form, latitude, 35, 0.02, form == SteadyForm::mixed_layer ? 1e-4 : 1.2e-3);
      if (form == SteadyForm::mixed_layer) sea.water_m = 120;
      HourlyStress hourly = step({0.15, 0.05}, 30);
      for (std::size_t h = 12; h < 31; ++h) hourly.stress_pa[h] = {-0.05, 0.1};
      const LevelResponses steady = sea.steady(depths);
      CrankNicolsonColumn numeric(35, 175, 0.02, sea.p.bottom_friction_m_s, sea.f(), 60);
      double worst = 0;
      for (int minute = 0; minute < 30 * 60; ++minute) {
        const auto h = static_cast<std::size_t>(minute / 60);
        const double share = (minute % 60 + 0.5) / 60.0;
        numeric.step(sea.p.stress_factor / rho *
                         ((1 - share) * hourly.stress_pa[h] + share * hourly.stress_pa[h + 1]),
                     0);
        if ((minute + 1) % 60 != 0) continue;
        const auto transient = sea.transient(depths, hourly, static_cast<double>(h + 1));
        for (std::size_t k = 0; k < depths.size(); ++k) {
          const Horizontal unsteady = hourly.stress_pa[h + 1] * steady.stress(k) + transient[k];
          worst = std::max(worst, std::abs(unsteady - numeric.at_depth(depths[k])));
        }
      }
      EXPECT_LT(worst, 1e-3) << name_of(form) << ' ' << latitude;
    }
  }
}

TEST(UnsteadyColumn, DeepWaterGivesFredholmsSolution) {
  // fields/docs/physics.md, section 5: 0.194775 Pa to the east, 5 m down, nu 0.02, 54 N; by
  // 24 h the wind is felt 140 m down, the bed at 400 m and its friction are not. The stress
  // rises here within an hour centred on the instant of the step.
  Sea sea(SteadyForm::finite_depth, 54, 400, 0.02, 1e-5);
  sea.p.stress_factor = 1;
  const std::vector<double> depth{5.0};
  const double stress_pa = 0.194775;
  const auto unsteady = [&](double h) {
    return stress_pa * sea.steady(depth).stress(0) +
           sea.transient(depth, step(stress_pa, 26), h + 0.5)[0];
  };
  // Half an hour of rise blunts inertial motion by (f h/2)^2/6, 0.8 %.
  EXPECT_LT(std::abs(unsteady(24) - Horizontal(0.0320280431810251, -0.09836348476932807)), 1e-3);
  EXPECT_LT(std::abs(unsteady(6) - Horizontal(0.07407559494755102, -0.11207115993717046)), 2e-3);
}

TEST(UnsteadyColumn, AStiffMixedLayerIsTheSlabOfPollardAndMillard) {
  // dW/dt + (r/h + i f) W = T/(rho h), fourth-order Runge-Kutta; the shear left is T h/(rho nu).
  Sea sea(SteadyForm::mixed_layer, 43, 22, 100.0, 5e-5);
  sea.water_m = 200;
  HourlyStress hourly = step({0.2, -0.1}, 60);
  for (std::size_t h = 20; h < 61; ++h) hourly.stress_pa[h] = {-0.1, 0.3};
  const std::vector<double> depths{0.0, 11.0, 22.0};
  const LevelResponses steady = sea.steady(depths);
  const auto tendency = [&](double hour, Horizontal w) {
    const auto i = std::min(static_cast<std::size_t>(hour), hourly.stress_pa.size() - 2);
    const double share = hour - static_cast<double>(i);
    const Horizontal stress = (1 - share) * hourly.stress_pa[i] + share * hourly.stress_pa[i + 1];
    return 3600.0 *
           (sea.p.stress_factor * stress / (rho * 22) - Horizontal(5e-5 / 22, sea.f()) * w);
  };
  Horizontal slab{};
  constexpr double dt = 0.02;
  for (int n = 0; n < 3000; ++n) {
    const double t = n * dt;
    const Horizontal a = tendency(t, slab);
    const Horizontal b = tendency(t + dt / 2, slab + 0.5 * dt * a);
    const Horizontal c = tendency(t + dt / 2, slab + 0.5 * dt * b);
    const Horizontal d = tendency(t + dt - 1e-12, slab + dt * c);
    slab += dt / 6 * (a + 2.0 * b + 2.0 * c + d);
    if ((n + 1) % 250 != 0) continue;
    const double hour = (n + 1) * dt;
    const auto transient = sea.transient(depths, hourly, hour);
    const auto h = static_cast<std::size_t>(std::lround(hour));
    for (std::size_t k = 0; k < depths.size(); ++k) {
      EXPECT_LT(std::abs(hourly.stress_pa[h] * steady.stress(k) + transient[k] - slab), 2e-4)
          << hour << ' ' << depths[k];
    }
  }
  EXPECT_GT(std::abs(slab), 0.05);
}

TEST(UnsteadyColumn, AMixedLayerAsDeepAsTheWaterMovesAsTheFiniteColumn) {
  const std::vector<double> depths{0, 4, 20, 35};
  const Sea mixed(SteadyForm::mixed_layer, 50, 35, 0.02, 8e-4);
  const Sea finite(SteadyForm::finite_depth, 50, 35, 0.02, 8e-4);
  for (const double hour : {0.5, 7.0, 15.3})
    EXPECT_EQ(mixed.transient(depths, step({0.2, 0.1}, 12), hour),
              finite.transient(depths, step({0.2, 0.1}, 12), hour));
}

TEST(UnsteadyColumn, BelowTheMixedLayerTheMotionOfItsBaseDiesOut) {
  Sea sea(SteadyForm::mixed_layer, 50, 20, 0.02, 1e-4);
  sea.water_m = 90;
  const auto w = sea.transient({20, 25, 40}, step({0.2, 0.1}, 12), 9);
  EXPECT_GT(std::abs(w[0]), 0.01);
  EXPECT_LT(std::abs(w[1] - w[0] * std::exp(-1.0)), 1e-15);
  EXPECT_LT(std::abs(w[2] - w[0] * std::exp(-4.0)), 1e-15);
}

TEST(UnsteadyColumn, FromRestTheSeaStartsAtRest) {
  // The modes sum to the steady response: 4 s after the stress begins to rise nothing moves but
  // the thin layer of the modes that answer at once, which are 10 % of it at 5 m and less below.
  const std::vector<double> depths{5, 20, 39};
  for (const SteadyForm form : moving_forms) {
    const Sea sea(form, 50, 40, 0.03, 8e-4);
    const double soon_h = 1e-3;
    const Horizontal stress(0.2, 0.1);
    const auto transient = sea.transient(depths, step(stress, 3), soon_h);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      const Horizontal at_once = soon_h * stress * sea.steady(depths).stress(k);
      EXPECT_LT(std::abs(at_once + transient[k]), 0.1 * std::abs(at_once));
    }
  }
}

TEST(UnsteadyColumn, UnderAConstantWindTheSteadyFormIsLeftAndTheEnergyOfTheRestDecays) {
  std::vector<double> depths;
  for (int i = 0; i < 35; ++i) depths.push_back(i + 0.5);
  for (const SteadyForm form : moving_forms) {
    const Sea sea(form, -40, 35, 0.02, 1.2e-3);
    const UnsteadyColumn column = sea.column(depths, step({0.2, -0.1}, 240));
    std::vector<Horizontal> w(depths.size());
    double before = 1e9;
    for (int h = 1; h <= 240; ++h) {
      column.transient(TimeCell::instant(add_hours(start, h)), w);
      double energy = 0;
      for (const Horizontal& x : w) energy += std::norm(x);
      EXPECT_LT(energy, before);
      before = energy;
    }
    EXPECT_LT(before, 1e-10);
  }
}

TEST(UnsteadyColumn, TurnsWithTheAxesAndMirrorsInTheSouth) {
  const std::vector<double> depths{1, 10, 30};
  const Horizontal turn = std::exp(Horizontal(0, 0.7));
  const Horizontal stress(0.1, 0.2);
  for (const SteadyForm form : moving_forms) {
    const Sea north(form, 45, 35, 0.02, 1e-3);
    const Sea south(form, -45, 35, 0.02, 1e-3);
    const auto a = north.transient(depths, step(stress, 20), 9);
    const auto b = north.transient(depths, step(turn * stress, 20), 9);
    const auto m = south.transient(depths, step(std::conj(stress), 20), 9);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      EXPECT_GT(std::abs(a[k]), 1e-3);
      EXPECT_LT(std::abs(turn * a[k] - b[k]), 1e-15);
      EXPECT_LT(std::abs(std::conj(a[k]) - m[k]), 1e-15);
    }
  }
}

TEST(UnsteadyColumn, WithoutRotationOrALayerThatMovesThereIsNone) {
  const std::vector<double> depths{1};
  for (const Sea& sea : {Sea(SteadyForm::finite_depth, 1, 35, 0.02, 1e-3),
                         Sea(SteadyForm::mixed_layer, -2, 35, 0.02, 1e-3),
                         Sea(SteadyForm::three_layer, 50, 350, 0.02, 1e-3)})
    EXPECT_EQ(sea.transient(depths, step(0.3, 9), 5)[0], Horizontal(0, 0));
}

}  // namespace
}  // namespace slackwater::unsteady_column_test
