#include "twin/climate/extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"
#include "twin/risk/workability/calendar.h"

namespace slackwater::twin::extremes_test {
namespace {

constexpr double nan = constants::nan;
using Peaks = std::vector<StormPeak>;

TEST(StormPeaks, AreFarEnoughApart) {
  const std::vector<double> values{0, 5, 7, 0, 6, 0, 0, 0, 8, 8, 0, 4};
  EXPECT_EQ(storm_peaks(values, 4.5, 3), (Peaks{{2, 7}, {8, 8}}));
  EXPECT_EQ(storm_peaks(values, 4.5, 1), (Peaks{{2, 7}, {4, 6}, {8, 8}}));
  EXPECT_EQ(storm_peaks(values, 4.5, 4), (Peaks{{8, 8}}));
  EXPECT_EQ(storm_peaks(values, 8, 1), Peaks{});  // above is above
  EXPECT_EQ(storm_peaks(values, 7.5, 1), (Peaks{{8, 8}}));
}

TEST(StormPeaks, AGapIsNeitherAboveNorBelow) {
  EXPECT_EQ(storm_peaks(std::vector<double>{5, nan, 6}, 4, 2), (Peaks{{2, 6}}));
  EXPECT_EQ(storm_peaks(std::vector<double>{5, nan, nan, 6}, 4, 2), (Peaks{{0, 5}, {3, 6}}));
  EXPECT_EQ(storm_peaks(std::vector<double>{nan, nan}, 4, 2), Peaks{});
}

TEST(StormPeaks, PossibleThresholdsLieHalfWayBetweenNeighbours) {
  std::vector<double> values{nan};
  for (int i = 0; i < 100; ++i) values.push_back(std::floor(i / 10.0));  // ten of each of 0 to 9
  EXPECT_EQ(possible_thresholds(values), (std::vector<double>{8.5, 7.5, 6.5}));
  EXPECT_EQ(possible_thresholds(std::vector<double>(50, 1.0)), std::vector<double>{});
  EXPECT_EQ(possible_thresholds(std::vector<double>{}), std::vector<double>{});
}

TEST(YearMaxima, OfYearsThatAreComplete) {
  // Daily; 2001 from July on, 2002 whole, 2003 with a gap of 40 days.
  const StepClock clock{parse_utc("2001-07-01T00:00:00Z"), std::chrono::hours(24), 184 + 365 + 365};
  std::vector<double> values(clock.steps, 1);
  values[0] = 9;
  values[184 + 100] = 5;
  std::fill_n(values.begin() + 184 + 365 + 100, 40, nan);
  const std::vector<YearMaximum> maxima = year_maxima(values, clock);
  ASSERT_EQ(maxima.size(), 1U);
  EXPECT_EQ(maxima.front().year, 2002);
  EXPECT_EQ(maxima.front().value, 5);
  EXPECT_EQ(maxima.front().step, 284U);
}

/// A winter's storms are of December and January: a year without one of its months may have had its
/// greatest there.
TEST(YearMaxima, AYearWithoutAMonthIsNotComplete) {
  const StepClock clock{parse_utc("2001-01-01T00:00:00Z"), std::chrono::hours(24), 365};
  std::vector<double> values(clock.steps, 1);
  std::fill_n(values.begin(), 15, nan);
  EXPECT_EQ(year_maxima(values, clock).size(), 1U);
  std::fill_n(values.begin(), 16, nan);  // 349 of 365 days are known, 15 of January
  EXPECT_EQ(year_maxima(values, clock).size(), 0U);
}

/// Storms of one step, as many as a Poisson number of so many a year, with Pareto peaks.
std::vector<StormPeak> made_up_storms(const Pareto& truth, double threshold, double per_year,
                                      double years, Rng& random) {
  std::vector<StormPeak> peaks;
  std::size_t step = 0;
  for (double at = 0; at < years;) {
    at -= std::log(1 - random.uniform()) / per_year;
    if (at < years)
      peaks.push_back({step++, threshold + truth.exceeded_with(1 - random.uniform())});
  }
  return peaks;
}

/// What a 90 % interval promises, held against 300 histories of 20 years whose truth is known, of
/// good fits. Nearly all of what it misses lies above it (api/docs/climate.md says so).
TEST(StormExtremes, IntervalsHoldTheTruthNineTimesInTen) {
  for (const double shape : {-0.15, 0.05}) {
    const Pareto truth{1.1, shape};
    const double threshold = 4;
    const double per_year = 5;
    const double years = 20;
    ExtremesQuestion question;
    question.return_years = {10, 50};
    question.resamples = 200;
    Rng random(11, "tests/storm_extremes");
    int held[2] = {0, 0};
    int below[2] = {0, 0};
    int refused = 0;
    const int twins = 300;
    for (int twin = 0; twin < twins; ++twin) {
      question.seed = static_cast<std::uint64_t>(twin);
      const auto fit = peaks_fit(made_up_storms(truth, threshold, per_year, years, random),
                                 threshold, years, question);
      ASSERT_TRUE(fit);
      if (!fit->is_good()) {
        ++refused;
        continue;
      }
      for (std::size_t v = 0; v < 2; ++v) {
        const ReturnValue& one = fit->returns[v];
        ASSERT_EQ(one.support, ReturnSupport::supported);
        const double value = threshold + truth.exceeded_with(1 / (per_year * one.years));
        held[v] += one.interval.low <= value && value <= one.interval.high ? 1 : 0;
        below[v] += value < one.interval.low ? 1 : 0;
      }
    }
    // Of a law that does end, one sample in fifteen has a value above where its fit ends; three
    // standard deviations of that are 13 of 300.
    EXPECT_LE(refused, shape < 0 ? 20 + 13 : 5) << shape;
    // Three standard deviations of 280 throws at 0.9 are 0.054.
    const int told = twins - refused;
    for (std::size_t v = 0; v < 2; ++v) {
      EXPECT_NEAR(1.0 * held[v] / told, 0.9, 0.054) << shape << " " << v;
      EXPECT_LE(1.0 * below[v] / told, 0.05) << shape << " " << v;
    }
  }
}

TEST(StormExtremes, IntervalsOfMaximaHoldTheTruthNineTimesInTen) {
  const ExtremeValue truth{6, 0.8, 0};
  ExtremesQuestion question;
  question.return_years = {50};
  question.resamples = 200;
  Rng random(12, "tests/year_maxima");
  int held = 0;
  const int twins = 300;
  for (int twin = 0; twin < twins; ++twin) {
    std::vector<double> maxima(25);
    for (double& value : maxima) value = truth.not_exceeded_with(1 - random.uniform());
    question.seed = static_cast<std::uint64_t>(twin);
    const auto fit = maxima_fit(maxima, false, question);
    ASSERT_TRUE(fit);
    const double value = truth.not_exceeded_with(std::exp(-1.0 / 50));
    held += fit->returns[0].interval.low <= value && value <= fit->returns[0].interval.high;
  }
  EXPECT_NEAR(1.0 * held / twins, 0.89, 0.055);
}

/// Hourly: a calm sea with storms of some hours, days apart, whose peaks are Pareto over 4.
struct MadeUpSea {
  StepClock clock;
  std::vector<double> values;
};
MadeUpSea made_up_sea(int years, const Pareto& truth, std::uint64_t seed) {
  MadeUpSea sea;
  sea.clock = {parse_utc("1980-01-01T00:00:00Z"), std::chrono::hours(1),
               static_cast<std::size_t>(years) * 8766};
  sea.values.assign(sea.clock.steps, 0);
  Rng random(seed, "tests/made_up_sea");
  for (double& value : sea.values) value = random.uniform(0.5, 2.5);
  // Every 730.5 hours a storm: twelve a year, none of them by chance near another.
  for (double at = 300; at + 20 < static_cast<double>(sea.clock.steps); at += 730.5) {
    const double peak = 4 + truth.exceeded_with(1 - random.uniform());
    for (int h = -10; h <= 10; ++h)
      sea.values[static_cast<std::size_t>(at) + static_cast<std::size_t>(10 + h)] =
          peak * (1 - std::abs(h) / 15.0);
  }
  return sea;
}

TEST(StormExtremes, OfAMadeUpSeaAreThoseItWasMadeWith) {
  const Pareto truth{1.0, -0.1};
  const MadeUpSea sea = made_up_sea(40, truth, 3);
  ExtremesQuestion question;
  question.threshold = 4;
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_EQ(found.no_peaks, NoPeaks::none);
  ASSERT_TRUE(found.peaks);
  EXPECT_EQ(found.years_known, 40);
  EXPECT_EQ(found.peaks->storms, 480U);
  EXPECT_LE(found.peaks->shape.low, -0.1);
  EXPECT_GE(found.peaks->shape.high, -0.1);
  for (const ReturnValue& one : found.peaks->returns) {
    ASSERT_EQ(one.support, ReturnSupport::supported);
    const double value = 4 + truth.exceeded_with(1 / (12 * one.years));
    EXPECT_LE(one.interval.low, value) << one.years;
    EXPECT_GE(one.interval.high, value) << one.years;
    EXPECT_LE(one.interval.low, one.value);
    EXPECT_GE(one.interval.high, one.value);
  }
  // Maxima of years tell of the same sea: the ways differ by less than their intervals.
  ASSERT_TRUE(found.gumbel && found.extreme_value);
  EXPECT_EQ(found.maxima.size(), 40U);
  const Interval90& ten_years = found.peaks->returns[1].interval;
  EXPECT_LE(found.extreme_value->returns[1].interval.low, ten_years.high);
  EXPECT_GE(found.extreme_value->returns[1].interval.high, ten_years.low);
  // Neighbouring thresholds tell the same: a Pareto tail stays one above any threshold.
  ASSERT_GE(found.other_thresholds.size(), 3U);
  for (const PeaksFit& other : found.other_thresholds) {
    if (other.threshold < 4) continue;
    EXPECT_GE(other.returns[1].value, ten_years.low) << other.threshold;
    EXPECT_LE(other.returns[1].value, ten_years.high) << other.threshold;
  }
}

TEST(StormExtremes, AThresholdIsTheGreatestWithTheStormsOfAYear) {
  const MadeUpSea sea = made_up_sea(20, {1.0, 0}, 4);
  const ExtremesQuestion question;
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_TRUE(found.peaks);
  EXPECT_TRUE(found.has_rate());
  EXPECT_EQ(found.rate, 5);
  EXPECT_GE(found.peaks->storms_per_year, 5);
  for (const double higher : possible_thresholds(sea.values)) {
    if (higher > found.peaks->threshold)
      EXPECT_LT(storm_peaks(sea.values, higher, question.separation_steps).size(), 100U) << higher;
  }
  for (std::size_t i = 1; i < found.other_thresholds.size(); ++i)
    EXPECT_LT(found.other_thresholds[i - 1].threshold, found.other_thresholds[i].threshold);
}

/// Twelve storms a year are in it, and no threshold has three hundred that are two days apart.
TEST(StormExtremes, ARateThatNoThresholdHasIsNotSaidToBeReached) {
  const MadeUpSea sea = made_up_sea(20, {1.0, 0}, 4);
  ExtremesQuestion question;
  question.storms_per_year = 300;
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_TRUE(found.peaks);
  EXPECT_FALSE(found.has_rate());
  for (const double other : possible_thresholds(sea.values))
    EXPECT_LE(storm_peaks(sea.values, other, question.separation_steps).size(),
              found.peaks->storms);
  question.threshold = 4;
  EXPECT_EQ(extremes_of(sea.values, sea.clock, question).rate, 0);
}

TEST(StormExtremes, TheSameSeedIsTheSameAnswer) {
  const MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  ExtremesQuestion question;
  const auto high = [&] {
    return extremes_of(sea.values, sea.clock, question).peaks->returns[1].interval.high;
  };
  const double first = high();
  EXPECT_EQ(high(), first);
  question.seed = 2;
  EXPECT_NE(high(), first);
  EXPECT_NEAR(high(), first, 0.8);  // the 95th percentile of 1000 samples, some 3 wide
}

/// Ten times the heights, ten times the answer.
TEST(StormExtremes, ScaleWithTheirUnit) {
  MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  const ExtremesQuestion question;
  const Extremes one = extremes_of(sea.values, sea.clock, question);
  for (double& value : sea.values) value *= 10;
  const Extremes ten = extremes_of(sea.values, sea.clock, question);
  EXPECT_NEAR(ten.peaks->threshold, 10 * one.peaks->threshold, 1e-9);
  EXPECT_NEAR(ten.peaks->returns[1].value, 10 * one.peaks->returns[1].value, 1e-9);
  EXPECT_NEAR(ten.gumbel->returns[1].interval.high, 10 * one.gumbel->returns[1].interval.high,
              1e-9);
}

TEST(StormExtremes, PeriodsBeyondTheHistoryAreNotSupported) {
  const MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  const Extremes found = extremes_of(sea.values, sea.clock, {});
  ASSERT_TRUE(found.peaks && found.gumbel);
  EXPECT_FALSE(found.extreme_value);
  EXPECT_EQ(found.peaks->returns[1].support, ReturnSupport::supported);       // 10 years of 12
  EXPECT_EQ(found.peaks->returns[2].support, ReturnSupport::beyond_history);  // 50 of 12
  EXPECT_EQ(found.peaks->returns[3].support, ReturnSupport::beyond_history);
  EXPECT_EQ(found.gumbel->returns[3].support, ReturnSupport::beyond_history);
}

TEST(StormExtremes, ADayOfWholeYearsMayBeMissing) {
  MadeUpSea sea = made_up_sea(5, {1.0, 0}, 4);
  std::fill_n(sea.values.begin(), 36, nan);
  ExtremesQuestion question;
  question.return_years = {20, 21};
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_TRUE(found.peaks);
  EXPECT_EQ(found.peaks->returns[0].support, ReturnSupport::supported);
  EXPECT_EQ(found.peaks->returns[1].support, ReturnSupport::beyond_history);
}

TEST(StormExtremes, WhatIsTooShortIsRefused) {
  const MadeUpSea sea = made_up_sea(2, {1.0, 0}, 4);
  const Extremes found = extremes_of(sea.values, sea.clock, {});
  EXPECT_EQ(found.no_peaks, NoPeaks::short_history);
  EXPECT_FALSE(found.peaks || found.gumbel);
  ExtremesQuestion high;
  high.threshold = 30;
  const MadeUpSea longer = made_up_sea(5, {1.0, 0}, 4);
  EXPECT_EQ(extremes_of(longer.values, longer.clock, high).no_peaks, NoPeaks::few_storms);
  const std::vector<double> flat(longer.clock.steps, 1.0);
  EXPECT_EQ(extremes_of(flat, longer.clock, {}).no_peaks, NoPeaks::all_alike);
  // A history full of gaps is as long as what is known of it.
  std::vector<double> thin = longer.values;
  std::fill_n(thin.begin(), 3 * 8766, nan);
  EXPECT_NEAR(extremes_of(thin, longer.clock, {}).years_known, 2, 0.001);
  EXPECT_EQ(extremes_of(thin, longer.clock, {}).no_peaks, NoPeaks::short_history);
}

/// Means of a month, on their own clock or laid on one of hours.
TEST(StormExtremes, OfCoarseStepsThereAreNone) {
  const StepClock months{parse_utc("1980-01-01T00:00:00Z"), std::chrono::minutes(43830), 360};
  Rng random(6, "tests/coarse_steps");
  std::vector<double> values(months.steps);
  for (double& value : values) value = random.uniform(0.5, 2.5);
  const Extremes found = extremes_of(values, months, {});
  EXPECT_EQ(found.no_peaks, NoPeaks::coarse_steps);
  EXPECT_FALSE(found.peaks || found.gumbel);
  EXPECT_TRUE(found.maxima.empty());
  const MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  ExtremesQuestion question;
  for (const auto& [hours, expected] :
       {std::pair{6, NoPeaks::none}, std::pair{7, NoPeaks::coarse_steps}}) {
    question.value_step = std::chrono::hours(hours);
    EXPECT_EQ(extremes_of(sea.values, sea.clock, question).no_peaks, expected) << hours;
  }
  question.value_step = std::chrono::hours(3);
  question.separation_steps = 2;
  EXPECT_EQ(extremes_of(sea.values, sea.clock, question).no_peaks, NoPeaks::coarse_steps);
}

/// Twelve years, of which summers, or all but the Januaries, are known.
TEST(StormExtremes, OfAPartOfTheYearAreNotThoseOfAYear) {
  MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  const auto without = [&](const auto& is_left_out) {
    std::vector<double> values = sea.values;
    for (const MonthSteps& month : months_of(sea.clock, std::nullopt))
      if (is_left_out(month))
        std::fill(values.begin() + static_cast<std::ptrdiff_t>(month.steps.begin),
                  values.begin() + static_cast<std::ptrdiff_t>(month.steps.end), nan);
    return extremes_of(values, sea.clock, {});
  };
  const Extremes summers =
      without([](const MonthSteps& one) { return one.month < 5 || one.month > 9; });
  EXPECT_EQ(summers.no_peaks, NoPeaks::seasons_missing);
  EXPECT_EQ(summers.months_missing, (std::vector{1, 2, 3, 4, 10, 11, 12}));
  EXPECT_FALSE(summers.peaks || summers.gumbel);
  EXPECT_TRUE(summers.other_thresholds.empty());
  const Extremes thin =
      without([](const MonthSteps& one) { return one.month == 1 && one.year % 3 != 0; });
  EXPECT_EQ(thin.months_missing, (std::vector{1}));
  EXPECT_EQ(thin.maxima.size(), 4U);
  const Extremes enough =
      without([](const MonthSteps& one) { return one.month == 1 && one.year % 3 == 0; });
  EXPECT_EQ(enough.no_peaks, NoPeaks::none);
}

/// A heavy tail has no moments to fit it by; one that ends below a storm that came is wrong.
TEST(StormExtremes, AFitThatIsNotGoodHasNoValue) {
  ExtremesQuestion question;
  question.return_years = {10};
  std::vector<StormPeak> peaks;
  peaks.reserve(101);
  const Pareto heavy{1, 0.8};
  for (int i = 0; i < 100; ++i) peaks.push_back({0, 4 + heavy.exceeded_with((i + 0.5) / 100)});
  const auto without_variance = peaks_fit(peaks, 4, 20, question);
  ASSERT_TRUE(without_variance);
  EXPECT_GE(without_variance->fit.shape, most_shape);
  EXPECT_EQ(without_variance->returns[0].support, ReturnSupport::no_good_fit);
  // Nearly even excesses have a shape near -1 and an end near the greatest: one beyond it.
  peaks.clear();
  for (int i = 0; i < 100; ++i) peaks.push_back({0, 4 + (i + 0.5) / 100});
  peaks.push_back({0, 5.1});
  const auto ends_too_soon = peaks_fit(peaks, 4, 20, question);
  ASSERT_TRUE(ends_too_soon);
  EXPECT_LT(ends_too_soon->upper_end(), 5.1);
  EXPECT_EQ(ends_too_soon->returns[0].support, ReturnSupport::no_good_fit);
  EXPECT_EQ(ends_too_soon->returns[0].value, 0);
  std::vector<double> maxima;
  maxima.reserve(101);
  for (int i = 0; i < 100; ++i) maxima.push_back((i + 0.5) / 100);
  maxima.push_back(2);
  const auto of_years = maxima_fit(maxima, true, question);
  ASSERT_TRUE(of_years);
  EXPECT_LT(of_years->fit.greatest(), 2);
  EXPECT_EQ(of_years->returns[0].support, ReturnSupport::no_good_fit);
}

TEST(StormExtremes, OfAFitThatIsNotGoodOtherThresholdsAreLeft) {
  const MadeUpSea sea = made_up_sea(20, {0.3, 0.9}, 5);
  ExtremesQuestion question;
  question.threshold = 4;
  question.return_years = {1, 10};
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_EQ(found.no_peaks, NoPeaks::no_good_fit);
  ASSERT_TRUE(found.peaks);
  for (const PeaksFit& one : found.other_thresholds)
    for (const ReturnValue& value : one.returns)
      EXPECT_EQ(value.support == ReturnSupport::no_good_fit, !one.is_good()) << one.threshold;
}

TEST(StormExtremes, WhatComesMoreOftenThanStormsIsBelowTheThreshold) {
  const MadeUpSea sea = made_up_sea(12, {1.0, 0}, 4);
  ExtremesQuestion question;
  question.return_years = {0.1, 10};
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  EXPECT_EQ(found.peaks->returns[0].support, ReturnSupport::below_threshold);
  EXPECT_EQ(found.peaks->returns[1].support, ReturnSupport::supported);
}

/// exp(-1/T) falls to nothing below a year, where a Gumbel has no end downwards.
TEST(StormExtremes, MaximaOfYearsDoNotTellLessThanAYear) {
  const MadeUpSea sea = made_up_sea(22, {1.0, 0}, 4);
  ExtremesQuestion question;
  question.return_years = {0.1, 0.99, 1};
  const Extremes found = extremes_of(sea.values, sea.clock, question);
  ASSERT_TRUE(found.gumbel && found.extreme_value);
  for (const auto* fit : {&*found.gumbel, &*found.extreme_value}) {
    EXPECT_EQ(fit->returns[0].support, ReturnSupport::below_year);
    EXPECT_EQ(fit->returns[1].support, ReturnSupport::below_year);
    EXPECT_EQ(fit->returns[2].support, ReturnSupport::supported);
    EXPECT_DOUBLE_EQ(fit->returns[2].value, fit->fit.location);
  }
}

}  // namespace
}  // namespace slackwater::twin::extremes_test
