#include "fields/current/unsteady_column.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/current/coriolis.h"

namespace slackwater {
namespace {

using std::chrono::hours;

const UtcTime start{hours(0)};

Calibration column(double latitude_deg, double water_depth_m, double viscosity, double friction) {
  Calibration c;
  c.form = SteadyForm::finite_depth;
  c.latitude = Angle::from_degrees(latitude_deg);
  c.water_depth_m = water_depth_m;
  c.wind_used = true;
  const auto add = [&](const char* name, double value) {
    c.parameters.emplace_back();
    c.parameters.back().name = name;
    c.parameters.back().value = value;
  };
  add("interior_east", 0);
  add("interior_north", 0);
  add("eddy_viscosity", viscosity);
  add("bottom_friction", friction);
  add("stress_factor", 1.1);
  return c;
}

LevelResponses responses_of(const Calibration& c, const std::vector<double>& depth_m) {
  return level_responses(c.form, steady_parameters(c), c.latitude, c.water_depth_m, depth_m);
}

/// A stress that rises from nothing within the first hour and then stands.
HourlyStress step(Horizontal stress_pa, int last_h) {
  HourlyStress hourly;
  hourly.first = start;
  hourly.stress_pa.assign(static_cast<std::size_t>(last_h) + 1, stress_pa);
  hourly.stress_pa[0] = 0;
  hourly.is_known.assign(hourly.stress_pa.size(), true);
  return hourly;
}

TimeCell at(double hour) { return TimeCell::instant(add_hours(start, hour)); }

TEST(TransientColumn, TheWavenumbersSolveTheirCondition) {
  for (const double friction : {1e-5, 5e-4, 2e-2}) {
    for (int n = 0; n < 12; ++n) {
      const double k = column_mode_wavenumber_1_m(n, 0.02, friction, 35);
      EXPECT_NEAR(k * std::sin(35 * k), friction / 0.02 * std::cos(35 * k), 1e-9 * (1 + k));
      EXPECT_GE(k * 35, n * constants::pi);
      EXPECT_LT(k * 35, (n + 0.5) * constants::pi);
    }
  }
}

TEST(TransientColumn, AgreesWithAnIndependentIntegrationInTime) {
  // Crank-Nicolson over finite volumes, second order in both: 0.2 m and 60 s leave 0.2 mm/s.
  for (const double latitude : {48.6, -35.0}) {
    const double nu = 0.02;
    const double friction = 1.2e-3;
    const double depth_m = 35;
    const Calibration c = column(latitude, depth_m, nu, friction);
    const Horizontal i_f(0, coriolis_parameter_rad_s(c.latitude));
    const std::vector<double> depths{0.1, 8.1, 20.1, 34.9};
    const LevelResponses steady = responses_of(c, depths);
    HourlyStress hourly = step({0.15, 0.05}, 30);
    for (std::size_t h = 12; h < 31; ++h) hourly.stress_pa[h] = {-0.05, 0.1};
    const TransientColumn transient(c, steady, hourly, 1.0 / 48);

    constexpr int cells = 175;
    const double dz = depth_m / cells;
    const double dt = 60;
    const double exchange = nu / (dz * dz);
    // The linear drag acts through half a cell of viscosity.
    const double drag = 1.0 / (1.0 / friction + 0.5 * dz / nu) / dz;
    std::vector<Horizontal> w(cells);
    std::vector<Horizontal> right(cells);
    std::vector<Horizontal> upper(cells);
    const auto diagonal = [&](int j) {
      return -i_f - exchange * ((j > 0) + (j + 1 < cells)) - (j + 1 == cells ? drag : 0.0);
    };
    const double factor = 1.1 / constants::sea_water_density_kg_m3;
    double worst = 0;
    for (int minute = 0; minute < 30 * 60; ++minute) {
      const auto h = static_cast<std::size_t>(minute / 60);
      const double share = (minute % 60 + 0.5) / 60.0;
      const Horizontal stress = (1 - share) * hourly.stress_pa[h] + share * hourly.stress_pa[h + 1];
      for (int j = 0; j < cells; ++j) {
        const auto u = static_cast<std::size_t>(j);
        Horizontal tendency = diagonal(j) * w[u];
        if (j > 0) tendency += exchange * w[u - 1];
        if (j + 1 < cells) tendency += exchange * w[u + 1];
        right[u] = w[u] + 0.5 * dt * tendency;
        if (j == 0) right[u] += dt * factor * stress / dz;
      }
      const double off = -0.5 * dt * exchange;
      Horizontal pivot = 1.0 - 0.5 * dt * diagonal(0);
      for (int j = 0; j < cells; ++j) {
        const auto u = static_cast<std::size_t>(j);
        if (j > 0) {
          pivot = 1.0 - 0.5 * dt * diagonal(j) - off * upper[u - 1];
          right[u] -= off * right[u - 1];
        }
        upper[u] = off / pivot;
        right[u] /= pivot;
      }
      w[cells - 1] = right[cells - 1];
      for (int j = cells - 2; j >= 0; --j) {
        const auto u = static_cast<std::size_t>(j);
        w[u] = right[u] - upper[u] * w[u + 1];
      }
      if ((minute + 1) % 60 != 0) continue;
      for (std::size_t k = 0; k < depths.size(); ++k) {
        const Horizontal unsteady = hourly.stress_pa[h + 1] * steady.stress(k) +
                                    transient.velocity(k, at(static_cast<double>(h + 1)));
        const auto u = static_cast<std::size_t>(depths[k] / dz);
        worst = std::max(worst, std::abs(unsteady - w[u]));
      }
    }
    EXPECT_LT(worst, 1e-3) << latitude;
  }
}

TEST(TransientColumn, DeepWaterGivesFredholmsSolution) {
  // physics_checks.yaml, fredholm_step_wind: 0.194775 Pa to the east, 5 m down, nu 0.02, 54 N; by
  // 24 h the wind is felt 140 m down, the bed at 400 m and its friction are not. The stress
  // rises here within an hour centred on the instant of the step.
  Calibration c = column(54, 400, 0.02, 1e-5);
  c.parameters[4].value = 1;
  const std::vector<double> depth{5.0};
  const LevelResponses steady = responses_of(c, depth);
  const double stress_pa = 0.194775;
  const TransientColumn transient(c, steady, step(stress_pa, 26), 1.0 / 48);
  const auto unsteady = [&](double h) {
    return stress_pa * steady.stress(0) + transient.velocity(0, at(h + 0.5));
  };
  // Half an hour of rise blunts inertial motion by (f h/2)^2/6, 0.8 %.
  EXPECT_LT(std::abs(unsteady(24) - Horizontal(0.0320280431810251, -0.09836348476932807)), 1e-3);
  EXPECT_LT(std::abs(unsteady(6) - Horizontal(0.07407559494755102, -0.11207115993717046)), 2e-3);
}

TEST(TransientColumn, FromRestTheSeaStartsAtRest) {
  // The modes sum to the steady response: 4 s after the stress begins to rise nothing moves but
  // the thin layer of the modes that answer at once, which are 10 % of it at 5 m and less below.
  const Calibration c = column(50, 40, 0.03, 8e-4);
  const std::vector<double> depths{5, 20, 39};
  const LevelResponses steady = responses_of(c, depths);
  const double soon_h = 1e-3;
  const Horizontal stress(0.2, 0.1);
  const TransientColumn transient(c, steady, step(stress, 3), 1.0 / 48);
  for (std::size_t k = 0; k < depths.size(); ++k) {
    const Horizontal at_once = soon_h * stress * steady.stress(k);
    EXPECT_LT(std::abs(at_once + transient.velocity(k, at(soon_h))), 0.1 * std::abs(at_once));
  }
}

TEST(TransientColumn, UnderAConstantWindTheSteadyFormIsLeftAndTheEnergyOfTheRestDecays) {
  const Calibration c = column(-40, 35, 0.02, 1.2e-3);
  std::vector<double> depths;
  for (int i = 0; i < 35; ++i) depths.push_back(i + 0.5);
  const TransientColumn transient(c, responses_of(c, depths), step({0.2, -0.1}, 240), 1.0 / 48);
  std::vector<Horizontal> w(depths.size());
  double before = 1e9;
  for (int h = 1; h <= 240; ++h) {
    transient.velocities(at(h), w);
    double energy = 0;
    for (const Horizontal& x : w) energy += std::norm(x);
    EXPECT_LT(energy, before);
    before = energy;
  }
  EXPECT_LT(before, 1e-10);
}

TEST(TransientColumn, TurnsWithTheAxesAndMirrorsInTheSouth) {
  const std::vector<double> depths{1, 10, 30};
  for (const SteadyForm form : {SteadyForm::finite_depth, SteadyForm::three_layer}) {
    Calibration north = column(45, 35, 0.02, 1e-3);
    Calibration south = column(-45, 35, 0.02, 1e-3);
    north.form = south.form = form;
    const Horizontal turn = std::exp(Horizontal(0, 0.7));
    const Horizontal stress(0.1, 0.2);
    const TransientColumn a(north, responses_of(north, depths), step(stress, 20), 1.0 / 48);
    const TransientColumn b(north, responses_of(north, depths), step(turn * stress, 20), 1.0 / 48);
    const TransientColumn m(south, responses_of(south, depths), step(std::conj(stress), 20),
                            1.0 / 48);
    for (std::size_t k = 0; k < depths.size(); ++k) {
      EXPECT_GT(std::abs(a.velocity(k, at(9))), 1e-3);
      EXPECT_LT(std::abs(turn * a.velocity(k, at(9)) - b.velocity(k, at(9))), 1e-15);
      EXPECT_LT(std::abs(std::conj(a.velocity(k, at(9))) - m.velocity(k, at(9))), 1e-15);
    }
  }
}

TEST(TransientColumn, WithoutRotationOrWindThereIsNone) {
  Calibration c = column(1, 35, 0.02, 1e-3);
  const std::vector<double> depths{1};
  EXPECT_EQ(TransientColumn(c, responses_of(c, depths), step(0.3, 9), 0.02).velocity(0, at(5)),
            Horizontal(0, 0));
  c = column(50, 35, 0.02, 1e-3);
  c.wind_used = false;
  EXPECT_EQ(TransientColumn(c, responses_of(c, depths), step(0.3, 9), 0.02).velocity(0, at(5)),
            Horizontal(0, 0));
}

}  // namespace
}  // namespace slackwater
