// 10 m/s of turning wind, 35 levels x 24 h, 2 cm/s of noise: how well the truth is found, and how
// honest the stated uncertainty is, over many twins. 100 of them; SLACKWATER_TWINS=500 for the
// whole table.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "fields/base/numbers/statistics.h"
#include "tests/calibration/solve/synthetic_day.h"
#include "tests/support/asked_number.h"

namespace slackwater::calibration::twin_targets_test {
namespace {

int twins() { return std::max(20, slackwater::tests::asked_number("SLACKWATER_TWINS", 100)); }

/// Counts between which a binomial number lies with at least 99 %: half a percent outside either
/// end.
std::pair<int, int> binomial_range(int n, double p) {
  std::pair<int, int> range{-1, -1};
  double log_term = n * std::log1p(-p);
  double below = 0;
  for (int k = 0; k <= n; ++k) {
    below += std::exp(log_term);
    if (range.first < 0 && below >= 0.005) range.first = k;
    if (range.second < 0 && below >= 0.995) range.second = k;
    log_term += std::log(static_cast<double>(n - k)) - std::log(k + 1.0) + std::log(p / (1 - p));
  }
  return range;
}

SyntheticDay twin(std::uint64_t seed) {
  SyntheticDay day;
  day.seed = seed;
  day.water_depth_m = 36;
  day.depth_m.clear();
  for (int k = 0; k < 35; ++k) day.depth_m.push_back(k + 0.5);
  Rng rng(seed, "tests/twin_targets");
  const Horizontal interior = std::polar(rng.uniform(0.1, 0.4), rng.uniform(0, 2 * constants::pi));
  day.truth.interior_east_m_s = interior.real();
  day.truth.interior_north_m_s = interior.imag();
  day.truth.eddy_viscosity_m2_s = 0.03 * std::exp(0.7 * rng.normal());
  day.truth.bottom_friction_m_s = 5e-4 * std::exp(0.5 * rng.normal());
  day.truth.stress_factor = std::exp(0.2 * rng.normal());
  day.latitude_deg = (seed % 2 == 0 ? 1 : -1) * rng.uniform(25, 65);
  return day;
}

/// The day with a wind of 10 m/s that turns by 6 degrees an hour, at 24 instants.
CalibrationInput twin_input(const SyntheticDay& day) {
  CalibrationInput input = synthetic_input(day);
  for (int i = 0; i < static_cast<int>(input.wind->value.size()); ++i)
    input.wind->value[static_cast<std::size_t>(i)] = vector_from_direction(10.0, 230.0 + 6.0 * i);
  const StressSeries series(*input.wind, input.drag_law);
  const LevelResponses r =
      level_responses(day.form, day.truth, input.latitude, day.water_depth_m, day.depth_m);
  VectorColumn& current = input.current;
  current.time.resize(24);
  current.source.resize(24);
  current.value.resize(24 * r.levels());
  current.status.resize(24 * r.levels());
  Rng rng(day.seed, "tests/twin_targets/noise");
  for (std::size_t t = 0; t < 24; ++t) {
    for (std::size_t k = 0; k < r.levels(); ++k) {
      const double east = 0.02 * rng.normal();
      current.value[current.offset(t, k)] = day.truth.interior_m_s() * r.interior(k) +
                                            *series.over(current.time[t]) * r.stress(k) +
                                            Horizontal(east, 0.02 * rng.normal());
    }
  }
  return input;
}

struct Row {
  std::string name;
  std::vector<double> error;  ///< relative; of the interior's components: to its speed
  int covered = 0;
};

double median_modulus(std::vector<double> values) {
  for (double& v : values) v = std::abs(v);
  return upper_median(std::move(values));
}

std::vector<Row> fit_all(int n) {
  std::vector<Row> rows;
  for (int seed = 1; seed <= n; ++seed) {
    const SyntheticDay day = twin(static_cast<std::uint64_t>(seed));
    const Calibration fitted = calibrate_day(twin_input(day));
    const std::vector<double> errors = estimate_errors(fitted, day.truth);
    rows.resize(errors.size());
    for (std::size_t i = 0; i < errors.size(); ++i) {
      const Parameter& p = fitted.parameters[i];
      rows[i].name = p.name;
      rows[i].error.push_back(p.is_logarithmic ? std::expm1(errors[i])
                                               : errors[i] / std::abs(day.truth.interior_m_s()));
      rows[i].covered += std::abs(errors[i]) <= 1.959964 * p.sigma ? 1 : 0;
    }
  }
  return rows;
}

TEST(TwinTargets, TheBinomialRangeOf500TwinsIsWithinThatOfTheTarget) {
  EXPECT_EQ(binomial_range(500, 0.95),
            (std::pair{462, 487}));  // 0.922 x 500 = 461, 0.974 x 500 = 487
}

TEST(TwinTargets, FactorViscosityAndInteriorAreFoundWithinFivePercentAndCoveredAsStated) {
  const int n = twins();
  const auto [fewest, most] = binomial_range(n, 0.95);
  std::printf("%d twins: median |error|, bias, coverage of 95 %% intervals [%.3f, %.3f]\n", n,
              static_cast<double>(fewest) / n, static_cast<double>(most) / n);
  for (const Row& row : fit_all(n)) {
    double bias = 0;
    for (const double e : row.error) bias += e / n;
    const double median = median_modulus(row.error);
    std::printf("  %-16s %7.4f %8.4f %7.3f\n", row.name.c_str(), median, bias,
                static_cast<double>(row.covered) / n);
    EXPECT_GE(row.covered, fewest) << row.name;
    EXPECT_LE(row.covered, most) << row.name;
    if (row.name == "bottom_friction") continue;  // no target: the interior alone feels it
    EXPECT_LE(median, 0.05) << row.name;
    EXPECT_LE(std::abs(bias), 0.01) << row.name;
  }
}

}  // namespace
}  // namespace slackwater::calibration::twin_targets_test
