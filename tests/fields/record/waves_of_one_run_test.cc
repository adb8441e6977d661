// Height, period and direction of a sea are those of one run: made-up products with known values.
#include <gtest/gtest.h>

#include <algorithm>

#include "fields/base/constants.h"
#include "fields/interpolate/temporal.h"
#include "fields/record/choose.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::waves_of_one_run_test {
namespace {

using std::chrono::hours;
using namespace tests;

const UtcTime start = parse_utc("2024-06-11T00:00:00Z");

Origin regional(Origin origin) {
  origin.rank.is_regional = true;
  return origin;
}

TEST(WavesOfOneRun, PeriodsAndDirectionsAreOfTheRunWhoseHeightItIs) {
  KnownSeriesForTests sea;
  const auto waves = [&](const Origin& origin, int from_h, double height_m, double period_s) {
    sea.waves(
        origin, instants(start + hours(from_h), start + hours(48), hours(3)),
        [=](UtcTime) { return height_m; }, [=](UtcTime) { return period_s; },
        [](UtcTime) { return 300.0; });
  };
  waves(regional(analysis_of("regional", 1)), 24, 2.0, 8.0);
  waves(analysis_of("global", 2), 0, 2.6, 11.0);
  const Chosen<double> height = choose(sea.data.significant_height, {}, {});
  Choice like;
  like.like = &height.stretches;
  // The regional product has no period of its own.
  std::erase_if(sea.data.peak_period.pieces,
                [](const auto& piece) { return piece.origin->dataset == "regional"; });
  const Chosen<double> period = choose(sea.data.peak_period, {}, like);
  ASSERT_EQ(height.stretches.size(), 2u);
  EXPECT_EQ(height.stretches[0].to, start + hours(21));
  ASSERT_EQ(period.column.times(), 8u) << "the global one's period is not lent to the other";
  EXPECT_EQ(period.column.time.back().centre(), start + hours(21));
}

/// Waves of two datasets: the height and the period of each are its own.
struct TwoSeas {
  KnownSeriesForTests known;
  void add(const Origin& origin, int from_h, int to_h, double height_m, double period_s) {
    known.waves(
        origin, instants(start + hours(from_h), start + hours(to_h), hours(3)),
        [=](UtcTime) { return height_m; }, [=](UtcTime) { return period_s; },
        [](UtcTime) { return 300.0; });
  }
  /// Period beside height, as chosen.
  [[nodiscard]] std::vector<std::pair<double, double>> chosen(const Choice& choice) const {
    const Chosen<double> height = choose(known.data.significant_height, {}, choice);
    Choice like = choice;
    like.like = &height.stretches;
    const Chosen<double> period = choose(known.data.peak_period, {}, like);
    std::vector<std::pair<double, double>> both;
    for (std::size_t t = 0; t < height.column.times(); ++t) {
      const auto value = value_at(period.column, height.column.time[t].centre(), hours(3));
      both.emplace_back(height.column.value[t], value.value_or(constants::nan));
    }
    return both;
  }
};

TEST(WavesOfOneRun, OfTwoProductsWithoutANameEachKeepsItsPeriods) {
  for (const bool is_finer_first : {true, false}) {
    TwoSeas seas;
    Origin fine = analysis_of(is_finer_first ? "a" : "b", 1);
    Origin coarse = analysis_of(is_finer_first ? "b" : "a", 2);
    fine.product_id = coarse.product_id = "cf";
    fine.is_of_named_product = coarse.is_of_named_product = false;
    fine.rank.spacing_deg = 0.05;
    coarse.rank.spacing_deg = 0.5;
    seas.add(fine, 0, 48, 2.0, 8.7);
    seas.add(coarse, 0, 48, 2.6, 9.1);
    for (const auto& [height, period] : seas.chosen({})) {
      EXPECT_EQ(height, 2.0);
      EXPECT_EQ(period, 8.7);
    }
  }
}

TEST(WavesOfOneRun, AtAJoinThePeriodMovesWithItsHeight) {
  // The better one is the second by name, and begins later: the other is moved onto it.
  TwoSeas seas;
  seas.add(regional(analysis_of("z", 1)), 24, 48, 2.0, 8.0);
  seas.add(analysis_of("a", 2), 0, 48, 3.0, 12.0);
  const auto both = seas.chosen(Choice{.ramp = hours(6)});
  ASSERT_EQ(both.size(), 17u);
  for (std::size_t t = 0; t < both.size(); ++t) {
    const auto& [height, period] = both[t];
    EXPECT_NEAR(period, 4 * height, 1e-12) << t;
    if (t >= 8) EXPECT_EQ(period, 8.0) << "the values of the better one stay, at " << t;
  }
}

TEST(WavesOfOneRun, APeriodInADatasetOfItsOwnIsOfTheProductsOtherOne) {
  TwoSeas seas;
  Origin heights = analysis_of("waves/height", 1);
  Origin periods = analysis_of("waves/period", 2);
  heights.product_id = periods.product_id = "waves";
  seas.add(heights, 0, 24, 2.0, 8.0);
  seas.known.data.peak_period.pieces.clear();
  seas.add(periods, 0, 24, 9.0, 7.0);
  std::erase_if(seas.known.data.significant_height.pieces,
                [](const auto& piece) { return piece.origin->dataset == "waves/period"; });
  for (const auto& [height, period] : seas.chosen({})) {
    EXPECT_EQ(height, 2.0);
    EXPECT_EQ(period, 7.0);
  }
}

}  // namespace
}  // namespace slackwater::waves_of_one_run_test
