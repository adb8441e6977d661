#include "calibration/skill/tide_baseline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "fields/base/numbers/random.h"
#include "fields/current/tide.h"

namespace slackwater::calibration::tide_baseline_test {
namespace {

const UtcDay day_d = parse_day("2024-06-01");
const UtcTime end_of_d = UtcTime(day_d) + std::chrono::days(1);

/// Twenty days of noise around a tide at three levels, every `step_h` hours.
VectorColumn noisy(int step_h, bool means, int days = 20) {
  Rng random(11, "tide baseline");
  VectorColumn column;
  column.levels_m = {1.0, 10.0, 30.0};
  for (int t = -24 * days; t + (means ? step_h : 0) <= 0; t += step_h) {
    const UtcTime at = add_hours(end_of_d, t);
    column.time.push_back(means ? TimeCell{at, add_hours(at, step_h)} : TimeCell::instant(at));
    for (int k = 0; k < 3; ++k) {
      const double phase = 2 * 3.14159265 * t / 12.42;
      column.value.push_back(std::polar(0.4 - 0.1 * k, phase) +
                             0.1 * Horizontal(random.normal(), random.normal()));
      column.status.push_back(SampleStatus::ok);
    }
  }
  return column;
}

/// The same by the general analysis of `fields/current/tide.h`, one level at a time.
TideFit fitted_alone(const VectorColumn& column, std::size_t level) {
  static constexpr std::array<std::string_view, 5> names{"M2", "S2", "K1", "O1", "M4"};
  std::vector<TimeCell> time;
  std::vector<Horizontal> value;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (!column.has(t, level) || column.time[t].start < end_of_d - std::chrono::days(15)) continue;
    time.push_back(column.time[t]);
    value.push_back(column.value[column.offset(t, level)]);
  }
  const std::vector<SampleStatus> status(time.size(), SampleStatus::ok);
  return fit_prescribed_tide(time, value, status, names);
}

TEST(ColumnTide, IsTheGeneralAnalysisAtEveryLevel) {
  for (const int step_h : {1, 3}) {
    for (const bool means : {false, true}) {
      VectorColumn column = noisy(step_h, means);
      column.status[column.offset(column.times() - 5, 1)] = SampleStatus::missing;
      const ColumnTide tide(column, day_d);
      const TimeCell later{add_hours(end_of_d, 7), add_hours(end_of_d, 8)};
      const auto oscillation = tide.oscillation(std::vector<TimeCell>{later});
      for (std::size_t k = 0; k < 3; ++k) {
        ASSERT_TRUE(tide.has(k));
        const TideFit alone = fitted_alone(column, k);
        // Two factorisations of one problem with a condition below 100: rounding alone.
        EXPECT_LT(std::abs(tide.mean(k) - alone.mean), 1e-11) << step_h << means << k;
        EXPECT_LT(std::abs(oscillation[k] - tidal_oscillation(alone, later)), 1e-11)
            << step_h << means << k;
      }
    }
  }
}

TEST(ColumnTide, WhereSamplesCannotTellS2sSensesApartTheSmallestAnswerIsTaken) {
  // Every six hours S2 is +1, -1, +1 …: both senses look alike, and their sum is all that is known.
  VectorColumn column = noisy(6, false);
  for (std::size_t t = 0; t < column.times(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      column.value[column.offset(t, k)] = t % 2 == (column.times() - 1) % 2 ? 0.2 : -0.2;
  const ColumnTide tide(column, day_d);
  const auto at = [&](int h) {
    return tide.oscillation(std::vector<TimeCell>{TimeCell::instant(add_hours(end_of_d, h))})[0];
  };
  // Half to each sense: 0.2 cos(wt), a line through the samples, and no circle between them. The
  // table's S2 drifts from 12 h by 1e-7 rad in 15 days.
  EXPECT_LT(std::abs(at(12) - 0.2), 1e-6);
  EXPECT_LT(std::abs(at(6) + 0.2), 1e-6);
  EXPECT_LT(std::abs(at(3)), 1e-6);
  EXPECT_LT(std::abs(at(2) - 0.1), 1e-6);
}

TEST(ColumnTide, NoiseIsNotBlownUpBetweenTheSamples) {
  const ColumnTide tide(noisy(6, false), day_d);
  for (int h = 1; h <= 24; ++h) {
    const std::vector<TimeCell> cell{TimeCell::instant(add_hours(end_of_d, h))};
    // 0.4 m/s of M2 and some of 0.1 m/s of noise over 11 unknowns.
    EXPECT_LT(std::abs(tide.oscillation(cell)[0]), 0.6) << h;
  }
}

TEST(ColumnTide, NeedsFifteenDaysAtTheLevelItself) {
  VectorColumn column = noisy(1, false, 16);
  for (std::size_t t = 0; t < 48; ++t)
    column.status[column.offset(t, 2)] = SampleStatus::missing;  // 14 days are left
  const ColumnTide tide(column, day_d);
  EXPECT_TRUE(tide.has(0));
  EXPECT_FALSE(tide.has(2));
  const std::vector<TimeCell> now{TimeCell::instant(end_of_d)};
  EXPECT_NE(tide.oscillation(now)[0], Horizontal{});
  EXPECT_EQ(tide.oscillation(now)[2], Horizontal{});
  EXPECT_FALSE(ColumnTide(noisy(1, false, 14), day_d).has(0));
}

}  // namespace
}  // namespace slackwater::calibration::tide_baseline_test
