// A moored instrument that stands alone and states how much its samples scatter: does the forecast
// know? The truth is an ocean of other physics; the same samples with and without the statement.
#include <gtest/gtest.h>

#include <cmath>

#include "calibration/day/forecast_column.h"
#include "tests/support/known_series_for_tests.h"
#include "tests/support/unlike_ocean.h"

namespace slackwater::calibration::stated_noise_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay first_day = parse_day("2024-02-01");
constexpr int all_days = 30;
const std::vector<double> depth_m{3, 9, 16, 24, 31};

ForecastPlan plan_of(UtcDay day) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = UtcTime(day) + days(1);
  plan.dataset = "mooring";
  plan.depth_m = depth_m;
  plan.best.hindsight = true;
  for (int h = 0; h <= 24; ++h) plan.stamps.push_back(plan.end_of_day() + hours(h));
  return plan;
}

/// Hourly samples of the ocean with this noise, and its analysed wind.
KnownSeriesForTests moored(const UnlikeOcean& ocean, double noise_m_s,
                           std::optional<double> stated_m_s) {
  KnownSeriesForTests known;
  known.data.water_depth = {UnlikeOcean::water_depth_m, "site"};
  Origin origin = station_of("mooring");
  origin.stated_error_m_s = stated_m_s;
  Rng random(7, "tests/stated_noise");
  const auto time = instants(UtcTime(first_day), UtcTime(first_day) + days(all_days));
  known.current(origin, time, depth_m, [&](UtcTime when, double depth) {
    const double east = random.normal();
    return ocean.current(when, depth) + noise_m_s * Horizontal(east, random.normal());
  });
  known.wind(analysis_of("weather", 2), time,
             [&](UtcTime when, double) { return ocean.analysed_wind(when); });
  return known;
}

struct Met {
  double rmse_m_s = 0;
  double coverage = 0;
  double sigma_m_s = 0;
};

/// Our own forecast of the first day, against the water.
Met met(std::uint64_t seed, double noise_m_s, std::optional<double> stated_m_s) {
  const UnlikeOcean ocean(seed, first_day, all_days);
  const KnownSeriesForTests known = moored(ocean, noise_m_s, stated_m_s);
  Met met;
  double n = 0;
  for (int d = 17; d + 2 < all_days; d += 2) {
    const ForecastPlan plan = plan_of(first_day + days(d));
    const ColumnForecast made = forecast_column(known.data, Site{}, plan);
    EXPECT_EQ(made.calibration_problem, "");
    for (std::size_t t = 1; t < plan.stamps.size(); ++t) {
      for (std::size_t k = 0; k < depth_m.size(); ++k) {
        const std::size_t o = t * depth_m.size() + k;
        const Horizontal error =
            made.column.current_m_s[o] - ocean.current(plan.stamps[t], depth_m[k]);
        const double sigma = made.column.current_sigma_m_s[o];
        for (const double part : {error.real(), error.imag()}) {
          met.rmse_m_s += part * part;
          met.coverage += std::abs(part) <= 1.2816 * sigma ? 1 : 0;
          met.sigma_m_s += sigma * sigma;
          n += 1;
        }
      }
    }
  }
  return {std::sqrt(2 * met.rmse_m_s / n), met.coverage / n, std::sqrt(met.sigma_m_s / n)};
}

TEST(StatedNoise, MakesABetterForecastAndAnHonestBand) {
  double stated_square = 0;
  double silent_square = 0;
  double stated_held = 0;
  double silent_held = 0;
  constexpr int seeds = 3;
  for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
    const Met stated = met(seed, 0.2, 0.2);
    const Met silent = met(seed, 0.2, std::nullopt);
    const Met sharp = met(seed, 0.005, std::nullopt);
    std::printf(
        "ocean %d: error %.4f with the error stated, %.4f without; 80 %% band %.0f and %.0f %%; a "
        "sharp instrument %.4f, %.0f %%\n",
        static_cast<int>(seed), stated.rmse_m_s, silent.rmse_m_s, 100 * stated.coverage,
        100 * silent.coverage, sharp.rmse_m_s, 100 * sharp.coverage);
    stated_square += stated.rmse_m_s * stated.rmse_m_s;
    silent_square += silent.rmse_m_s * silent.rmse_m_s;
    stated_held += stated.coverage / seeds;
    silent_held += silent.coverage / seeds;
  }
  EXPECT_LT(std::sqrt(stated_square), 0.7 * std::sqrt(silent_square));
  EXPECT_NEAR(stated_held, 0.8, 0.1) << "before any past band has scaled it";
  EXPECT_GT(silent_held, 0.92) << "scatter taken for a sea that is hard to forecast";
}

TEST(StatedNoise, ThatTheValuesDoNotShowIsNoNoise) {
  // A stated error that lasts (a compass, a zero) cannot be averaged out: the values stand.
  const UnlikeOcean ocean(1, first_day, all_days);
  const KnownSeriesForTests known = moored(ocean, 0.005, 0.2);
  const auto noise = known_currents(known.data, plan_of(first_day + days(17))).record.noise_m_s;
  ASSERT_FALSE(noise.empty());
  for (const double one : noise) EXPECT_LT(one, 0.03);
  const KnownSeriesForTests silent = moored(ocean, 0.2, std::nullopt);
  EXPECT_TRUE(known_currents(silent.data, plan_of(first_day + days(17))).record.noise_m_s.empty());
}

}  // namespace
}  // namespace slackwater::calibration::stated_noise_test
