#include "calibration/skill/baseline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/current/astronomy.h"

namespace slackwater::calibration::baseline_test {
namespace {

const UtcDay day_d = parse_day("2024-06-01");
const UtcTime end_of_d = UtcTime(day_d) + std::chrono::days(1);
const Angle latitude = Angle::from_degrees(50.0);

/// Two levels, the second half as fast; hours from the end of D.
template <typename Function>
VectorColumn hourly(Function value, int first_h, int last_h, bool means) {
  VectorColumn column;
  column.levels_m = {1.0, 10.0};
  for (int t = first_h; t <= last_h; ++t) {
    const UtcTime at = add_hours(end_of_d, t);
    if (means && t == last_h) break;
    column.time.push_back(means ? TimeCell{at, at + std::chrono::hours(1)} : TimeCell::instant(at));
    const Horizontal v = value(means ? t + 0.5 : t);
    column.value.push_back(v);
    column.value.push_back(0.5 * v);
    column.status.insert(column.status.end(), 2, SampleStatus::ok);
  }
  return column;
}

Horizontal curve(double t_h) { return {0.3 + 0.01 * t_h, std::sin(0.3 * t_h)}; }

BaselineForecast made(Method baseline, const VectorColumn& history, const VectorColumn& truth) {
  const BaselineInput input{day_d, history, nullptr, latitude, false};
  BaselineOutcome outcome = make_baseline(baseline, input, truth.time, &truth);
  EXPECT_TRUE(outcome.forecast.has_value()) << name_of(baseline) << ": " << outcome.reason;
  return outcome.forecast.value_or(BaselineForecast{});
}

TEST(Method, NamesAreThoseOfTheReferenceInAlphabeticalOrder) {
  EXPECT_EQ(name_of(Method::persistence), "persistence");
  EXPECT_EQ(name_of(Method::reference_slab), "reference-slab");
  for (std::size_t i = 1; i < all_methods.size(); ++i) {
    EXPECT_LT(all_methods[i - 1], all_methods[i]);
    EXPECT_LT(name_of(all_methods[i - 1]), name_of(all_methods[i])) << "tables are printed in it";
  }
}

TEST(Baseline, ThereIsARecipeForEveryOneInTheListAndForNoOther) {
  const VectorColumn history = hourly(curve, -60, 0, false);
  const BaselineInput input{day_d, history, nullptr, latitude, false};
  for (const Method method : all_methods) {
    const bool is_listed =
        std::find(all_baselines.begin(), all_baselines.end(), method) != all_baselines.end();
    if (is_listed) {
      EXPECT_NO_THROW((void)make_baseline(method, input, {})) << name_of(method);
    } else {
      EXPECT_THROW((void)make_baseline(method, input, {}), ContractViolation) << name_of(method);
    }
  }
}

TEST(Persistence, HoldsTheInstantAt24HoursAtEveryLevel) {
  const VectorColumn history = hourly(curve, -48, 0, false);
  const VectorColumn truth = hourly(curve, 1, 30, false);
  const BaselineForecast forecast = made(Method::persistence, history, truth);
  for (std::size_t t = 0; t < truth.times(); ++t) {
    EXPECT_EQ(forecast.value[truth.offset(t, 0)], curve(0.0));
    EXPECT_EQ(forecast.value[truth.offset(t, 1)], 0.5 * curve(0.0));
  }
}

TEST(Persistence, TakesTheLastValueThatIsThereAndLeavesADryLevelMissing) {
  VectorColumn history = hourly(curve, -24, 0, false);
  history.status[history.offset(24, 0)] = SampleStatus::suspect;
  for (std::size_t t = 0; t < history.times(); ++t)
    history.status[history.offset(t, 1)] = SampleStatus::below_bed;
  const VectorColumn truth = hourly(curve, 1, 3, false);
  const BaselineForecast forecast = made(Method::persistence, history, truth);
  EXPECT_EQ(forecast.value[0], curve(-1.0));
  EXPECT_TRUE(forecast.has(0));
  EXPECT_FALSE(forecast.has(1));
}

TEST(DayMean, AClosedDayOfInstantsHasTwentyFiveAndOfMeansTwentyFour) {
  Horizontal instants{};
  Horizontal means{};
  for (int i = 0; i <= 24; ++i) instants += curve(i - 24.0) / 25.0;
  for (int i = 0; i < 24; ++i) means += curve(i - 23.5) / 24.0;
  const VectorColumn truth = hourly(curve, 1, 3, false);
  EXPECT_NEAR(
      std::abs(made(Method::day_mean, hourly(curve, -60, 0, false), truth).value[0] - instants), 0,
      1e-14);
  EXPECT_NEAR(std::abs(made(Method::day_mean, hourly(curve, -60, 0, true), truth).value[0] - means),
              0, 1e-14);
}

TEST(SameHour, RepeatsTheLastDayAtAnyLead) {
  for (const bool means : {false, true}) {
    const VectorColumn history = hourly(curve, -48, 0, means);
    const VectorColumn truth = hourly(curve, means ? 0 : 1, 72, means);
    const BaselineForecast forecast = made(Method::same_hour, history, truth);
    for (std::size_t t = 0; t < truth.times(); ++t) {
      const double lead_h = hours_between(end_of_d, truth.time[t].centre());
      const double back_h = lead_h - 24.0 * std::ceil(lead_h / 24.0);
      EXPECT_NEAR(std::abs(forecast.value[truth.offset(t, 0)] - curve(back_h)), 0, 1e-13) << lead_h;
    }
  }
}

TEST(TidePhase, RepeatsASeaOfThatPeriod) {
  const auto tide = [](double t_h) { return std::polar(0.4, 2 * constants::pi * t_h / 12.42); };
  const VectorColumn history = hourly(tide, -60, 0, false);
  const VectorColumn truth = hourly(tide, 1, 72, false);
  const BaselineForecast forecast = made(Method::tide_phase, history, truth);
  // Linear between hours: 0.4 (w dt)^2/8 = 0.013
  for (std::size_t i = 0; i < truth.value.size(); ++i)
    EXPECT_NEAR(std::abs(forecast.value[i] - truth.value[i]), 0, 0.013);
}

TEST(TidePhase, DoesNotReadAcrossAGap) {
  VectorColumn history = hourly(curve, -48, 0, false);
  for (std::size_t t = 20; t < 30; ++t)
    history.status[history.offset(t, 0)] = SampleStatus::missing;
  const VectorColumn truth = hourly(curve, 1, 24, false);
  const BaselineForecast forecast = made(Method::tide_phase, history, truth);
  EXPECT_FALSE(forecast.has(truth.offset(1, 0)));  // lead 2 h looks at -22.84 h, in the gap
  EXPECT_TRUE(forecast.has(truth.offset(1, 1)));
  EXPECT_TRUE(forecast.has(truth.offset(22, 0)));
}

TEST(TideHarmonic, PredictsAnExactTideAndItsMean) {
  const double m2 = tidal_constituent("M2").speed_rad_s * 3600.0;
  const double o1 = tidal_constituent("O1").speed_rad_s * 3600.0;
  const auto tide = [&](double t_h) {
    return Horizontal(0.05, 0.1) + std::polar(0.4, m2 * t_h + 1.0) + std::polar(0.1, -o1 * t_h);
  };
  const VectorColumn history = hourly(tide, -24 * 20, 0, false);
  const VectorColumn truth = hourly(tide, 1, 24, false);
  const BaselineForecast forecast = made(Method::tide_harmonic, history, truth);
  for (std::size_t i = 0; i < truth.value.size(); ++i)
    EXPECT_NEAR(std::abs(forecast.value[i] - truth.value[i]), 0, 1e-11);
  // The slab takes the same tide out and puts it back: what is left is a constant.
  const BaselineForecast slab = made(Method::reference_slab, history, truth);
  for (std::size_t i = 0; i < truth.value.size(); ++i)
    EXPECT_NEAR(std::abs(slab.value[i] - truth.value[i]), 0, 1e-11);
}

TEST(TideHarmonic, NeedsFifteenDays) {
  const VectorColumn history = hourly(curve, -24 * 15 + 1, 0, false);
  const VectorColumn truth = hourly(curve, 1, 2, false);
  const BaselineOutcome outcome =
      make_baseline(Method::tide_harmonic, {day_d, history, nullptr, latitude, false}, truth.time);
  EXPECT_FALSE(outcome.forecast.has_value());
  EXPECT_NE(outcome.reason.find("shorter than 15 days"), std::string::npos);
}

TEST(TideBaselines, OfDetidedCurrentsThereAreNoneAndTheReasonSaysSo) {
  const VectorColumn history = hourly(curve, -24 * 20, 0, false);
  const VectorColumn truth = hourly(curve, 1, 24, false);
  BaselineInput input{day_d, history, nullptr, latitude, false};
  input.tide_since = UtcTime::max();
  for (const Method baseline : {Method::tide_harmonic, Method::tide_phase}) {
    const BaselineOutcome outcome = make_baseline(baseline, input, truth.time);
    EXPECT_FALSE(outcome.forecast.has_value()) << name_of(baseline);
    EXPECT_NE(outcome.reason.find("detided"), std::string::npos) << outcome.reason;
    EXPECT_NE(outcome.reason.find(name_of(baseline)), std::string::npos) << outcome.reason;
  }
  EXPECT_TRUE(make_baseline(Method::same_hour, input, truth.time).forecast.has_value());
  // The slab of a detided record is that of one too short for a tide.
  const VectorColumn short_history = hourly(curve, -24 * 10, 0, false);
  const auto slab = make_baseline(Method::reference_slab, input, truth.time);
  const auto of_short = make_baseline(Method::reference_slab,
                                      {day_d, short_history, nullptr, latitude, false}, truth.time);
  ASSERT_TRUE(slab.forecast && of_short.forecast);
  EXPECT_EQ(slab.forecast->value, of_short.forecast->value);
}

TEST(TideBaselines, LookNoFartherBackThanTheTide) {
  const VectorColumn history = hourly(curve, -24 * 20, 0, false);
  const VectorColumn truth = hourly(curve, 1, 24, false);
  BaselineInput input{day_d, history, nullptr, latitude, false};
  input.tide_since = add_hours(end_of_d, -24 * 14);
  const BaselineOutcome harmonic = make_baseline(Method::tide_harmonic, input, truth.time);
  EXPECT_FALSE(harmonic.forecast.has_value());
  EXPECT_NE(harmonic.reason.find("as far as it holds tide, is shorter than 15 days"),
            std::string::npos)
      << harmonic.reason;
  input.tide_since = add_hours(end_of_d, -24 * 15);
  EXPECT_TRUE(make_baseline(Method::tide_harmonic, input, truth.time).forecast.has_value());
  input.tide_since = add_hours(end_of_d, -12);
  const auto phase = make_baseline(Method::tide_phase, input, truth.time).forecast;
  ASSERT_TRUE(phase);
  EXPECT_FALSE(phase->has(2 * 11)) << "12 h later: 12.84 h before the end of D";
  EXPECT_TRUE(phase->has(2 * 12)) << "13 h later: 11.84 h before it";
}

TEST(OracleMean, NoConstantIsBetter) {
  const VectorColumn history = hourly(curve, -24, 0, false);
  const VectorColumn truth = hourly(curve, 1, 24, false);
  const BaselineForecast oracle = made(Method::oracle_mean, history, truth);
  const auto misfit = [&](Horizontal constant) {
    double sum = 0;
    for (std::size_t t = 0; t < truth.times(); ++t)
      sum += std::norm(truth.value[truth.offset(t, 0)] - constant);
    return sum;
  };
  const Horizontal best = oracle.value[0];
  for (const Horizontal nudge :
       {Horizontal(1e-3, 0), Horizontal(-1e-3, 0), Horizontal(0, 1e-3), Horizontal(0, -1e-3)})
    EXPECT_GT(misfit(best + nudge), misfit(best));
  const BaselineInput input{day_d, history, nullptr, latitude, false};
  EXPECT_FALSE(make_baseline(Method::oracle_mean, input, truth.time).forecast.has_value());
}

TEST(Baseline, AHistoryThatReachesBeyondDIsABug) {
  const VectorColumn history = hourly(curve, -24, 1, false);
  EXPECT_THROW(
      (void)make_baseline(Method::persistence, {day_d, history, nullptr, latitude, false}, {}),
      ContractViolation);
}

TEST(Baseline, WithoutAnyCurrentOnDThereIsAReason) {
  const VectorColumn history = hourly(curve, -48, -30, false);
  const VectorColumn truth = hourly(curve, 1, 2, false);
  for (const Method baseline : {Method::persistence, Method::day_mean, Method::reference_slab}) {
    const auto outcome =
        make_baseline(baseline, {day_d, history, nullptr, latitude, false}, truth.time);
    EXPECT_FALSE(outcome.forecast.has_value());
    EXPECT_NE(outcome.reason.find("2024-06-01"), std::string::npos);
  }
}

}  // namespace
}  // namespace slackwater::calibration::baseline_test
