#include "calibration/day/given/horizon.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "tests/calibration/day/horizon_for_tests.h"

namespace slackwater::calibration::horizon_wind_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

constexpr WindPolicy all_policies[] = {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist};

TEST(WindPolicyNames, AreReadAsTheyAreWritten) {
  for (const WindPolicy policy : all_policies) EXPECT_EQ(wind_policy_from(name_of(policy)), policy);
  try {
    (void)wind_policy_from("storm");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find("'storm'"), std::string::npos);
  }
}

TEST(HorizonWind, IsEmptyWhereNoWindIsStored) {
  for (const WindPolicy policy : all_policies) {
    const HorizonWind wind = horizon_wind({}, policy, end_of_day, stamps_to(24));
    EXPECT_FALSE(wind.series);
    EXPECT_TRUE(wind.wind_m_s.empty());
    EXPECT_TRUE(wind.source.empty());
    EXPECT_TRUE(wind.origins.empty());
  }
  KnownSeriesForTests later;
  later.wind(analysis_of("wind"), instants(end_of_day + hours(1), end_of_day + days(1)), rising);
  EXPECT_TRUE(horizon_wind(later.data.wind, WindPolicy::forecast, end_of_day, stamps_to(24))
                  .wind_m_s.empty())
      << "nothing was known by the end of D";
}

TEST(HorizonWind, PersistedWindStartsAtTheLastValueAndForgetsItForTheMean) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day), rising);
  const std::vector<UtcTime> stamps = stamps_to(24 * 30);
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::persist, end_of_day, stamps);
  ASSERT_EQ(wind.wind_m_s.size(), stamps.size());
  const Horizontal last = rising(end_of_day, 0);
  const Horizontal mean = rising(end_of_day - days(2), 0);  // of a straight line: its middle
  EXPECT_EQ(wind.wind_m_s[0], last);
  for (std::size_t h = 0; h < stamps.size(); ++h) {
    const Horizontal expected = mean + std::exp(-double(h) / 24) * (last - mean);
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - expected), 0, 1e-12) << "rounding, " << h << " h";
  }
  EXPECT_NEAR(std::abs(wind.wind_m_s.back() - mean), 0, 1e-9);
  EXPECT_EQ(wind.source[0], DataStatus::analysis);
  EXPECT_EQ(count(wind.source, DataStatus::persisted), stamps.size() - 1);
}

TEST(HorizonWind, PersistedWindSeesNothingAfterTheDay) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day + days(3)), rising);
  sea.wind(forecast_of("wind", end_of_day - hours(12)),
           instants(end_of_day - hours(12), end_of_day + days(3)), rising_plus(1));
  ColumnData spoilt = sea.data;
  spoil_all_after(spoilt, end_of_day);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::persist, end_of_day, stamps_to(72));
  };
  EXPECT_EQ(made(sea.data).wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(made(sea.data).series->value, made(spoilt).series->value);
  EXPECT_EQ(made(sea.data).origins, made(spoilt).origins);
}

TEST(HorizonWind, ForecastSeesTheNewestRunIssuedByTheEndOfTheDay) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(72));
  ASSERT_EQ(wind.wind_m_s.size(), 73u);
  EXPECT_EQ(wind.wind_m_s[0], rising(end_of_day, 0)) << "analysed up to the end of D";
  EXPECT_EQ(wind.source[0], DataStatus::analysis);
  for (std::size_t h = 1; h < 73; ++h) {
    const double more = 2 - 2 * left_of_join(double(h));  // from the analysis onto the run
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0) - more), 0, 1e-12);
    EXPECT_EQ(wind.source[h], DataStatus::forecast);
  }
}

TEST(HorizonWind, ForecastNeverSeesWhatWasNotYetKnown) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, end_of_day, end_of_day);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::forecast, end_of_day, stamps_to(72));
  };
  EXPECT_EQ(made(sea.data).wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(made(sea.data).series->value, made(spoilt).series->value);
}

TEST(HorizonWind, BestTakesLaterAnalysisAndTheNewestRunAndSaysWhichIsWhich) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72));
  for (std::size_t h = 0; h < 73; ++h) {
    const bool analysed = h <= 24;
    // The run of +6 h leaves the analysis and meets the newest, of +36 h.
    const double more = analysed ? 0
                        : h >= 36
                            ? 4
                            : 3 - 3 * left_of_join(double(h) - 24) + left_of_join(36 - double(h));
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0) - more), 0, 1e-12)
        << h;
    EXPECT_EQ(wind.source[h], analysed ? DataStatus::analysis : DataStatus::forecast) << h;
  }
}

TEST(HorizonWind, BestOfAnIssueTimeIsWhatWasKnownThen) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const UtcTime issued = end_of_day + hours(5);
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, issued, issued);
  const auto made = [&](const ColumnData& data) {
    return horizon_wind(data.wind, WindPolicy::best, end_of_day, stamps_to(72), {issued, false});
  };
  const HorizonWind wind = made(sea.data);
  EXPECT_FALSE(wind.hindsight);
  EXPECT_EQ(wind.wind_m_s, made(spoilt).wind_m_s);
  EXPECT_EQ(wind.series->value, made(spoilt).series->value);
  EXPECT_EQ(wind.source[5], DataStatus::analysis) << "the hours up to the issue time are known";
  EXPECT_NE(wind.source[6], DataStatus::analysis);
  EXPECT_TRUE(
      horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72), {issued, true})
          .hindsight);
}

TEST(HorizonWind, WhereAForecastEndsItsLastValueIsPersisted) {
  KnownSeriesForTests sea;
  sea.wind(forecast_of("wind", end_of_day - hours(6)), instants(end_of_day, end_of_day + days(1)),
           rising);
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(48));
  const Horizontal last = rising(end_of_day + days(1), 0);
  const Horizontal mean = rising(end_of_day + hours(12), 0);
  for (std::size_t h = 0; h <= 24; ++h) EXPECT_EQ(wind.source[h], DataStatus::forecast);
  for (std::size_t h = 25; h <= 48; ++h) {
    EXPECT_EQ(wind.source[h], DataStatus::persisted);
    const Horizontal expected = mean + std::exp(-double(h - 24) / 24) * (last - mean);
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - expected), 0, 1e-12);
  }
}

TEST(HorizonWind, SixHourlyStampsAreJoinedByLines) {
  for (const int step_h : {6, 12}) {
    KnownSeriesForTests sea;
    sea.wind(analysis_of("wind"),
             instants(end_of_day - days(2), end_of_day + days(2), hours(step_h)), rising);
    const HorizonWind wind =
        horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(48));
    for (std::size_t h = 0; h <= 48; ++h) {
      EXPECT_NEAR(std::abs(wind.wind_m_s[h] - rising(end_of_day + hours(h), 0)), 0, 1e-12) << h;
      EXPECT_EQ(wind.source[h], DataStatus::analysis);
    }
  }
}

TEST(HorizonWind, CalibrationSeesTheStoredWindAndThenTheStamps) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(1), end_of_day - hours(3)), rising);
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(5));
  ASSERT_TRUE(wind.series);
  const VectorColumn& series = *wind.series;
  ASSERT_EQ(series.times(), 22u + 6u);
  EXPECT_TRUE(std::is_sorted(series.time.begin(), series.time.end(),
                             [](const TimeCell& a, const TimeCell& b) { return a.end < b.end; }));
  for (std::size_t t = 0; t < 22; ++t)
    EXPECT_EQ(series.value[t], rising(series.time[t].centre(), 0));
  for (std::size_t h = 0; h < 6; ++h) {
    EXPECT_EQ(series.value[22 + h], wind.wind_m_s[h]);
    EXPECT_EQ(series.source[22 + h], DataStatus::persisted);
  }
  EXPECT_EQ(wind.origins.size(), 22u);
}

TEST(HorizonWind, AnInstrumentSpeaksOnlyWhereThereIsNoProduct) {
  KnownSeriesForTests sea;
  const auto always = instants(end_of_day - days(2), end_of_day + days(1));
  sea.wind(station_of("mast", 9), always, rising_plus(5));
  const auto first = [&] {
    return horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(3)).wind_m_s[0];
  };
  EXPECT_EQ(first(), rising(end_of_day, 0) + 5.0);
  sea.wind(analysis_of("wind", 1), always, rising);
  EXPECT_EQ(first(), rising(end_of_day, 0));
}

TEST(HorizonWind, AGapInsideTheHorizonIsNamedAndTheValueAfterItIsNotCopiedIntoIt) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(4), end_of_day + days(1)),
           steady({5, 0}));
  sea.wind(analysis_of("wind", 2), instants(end_of_day + days(2), end_of_day + days(3)),
           steady({-9, 12}));
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(72));
  ASSERT_EQ(wind.gaps.size(), 1u);
  EXPECT_EQ(wind.gaps[0], (WindGap{end_of_day + days(1), end_of_day + days(2)}));
  EXPECT_EQ(count(wind.source, DataStatus::persisted), 23u);
  for (std::size_t h = 25; h <= 42; ++h)
    EXPECT_NEAR(std::abs(wind.wind_m_s[h] - Horizontal(5, 0)), 0, 1e-12) << h;
  for (std::size_t h = 43; h < 48; ++h) {
    const double back = (double(h) - 42) / 6;
    EXPECT_NEAR(
        std::abs(wind.wind_m_s[h] - ((1 - back) * Horizontal(5, 0) + back * Horizontal(-9, 12))), 0,
        1e-12)
        << h;
  }
  EXPECT_EQ(wind.wind_m_s[48], Horizontal(-9, 12));
  EXPECT_EQ(wind.extra_sigma_m_s[24], 0);
  EXPECT_GT(wind.extra_sigma_m_s[47], wind.extra_sigma_m_s[30]);
  EXPECT_EQ(wind.extra_sigma_m_s[48], 0);
}

TEST(HorizonWind, WindBroughtFromAnotherHeightIsTheLessCertain) {
  KnownSeriesForTests sea;
  sea.wind(analysis_of("wind"), instants(end_of_day - days(1), end_of_day + days(3)),
           steady({9, 12}));
  sea.data.wind.pieces[0].from_height_m = 100;
  const HorizonWind wind = horizon_wind(sea.data.wind, WindPolicy::best, end_of_day, stamps_to(24));
  const double share = 0.06 * std::log(10.0);
  EXPECT_NEAR(wind.extra_sigma_m_s[5], 15 * share / std::sqrt(2.0), 1e-12);
  EXPECT_EQ(wind.stretches.at(0).from_height_m, 100);
}

TEST(HorizonWind, ForecastSeesWhatWasPublishedByTheIssueTime) {
  const KnownSeriesForTests sea = analysed_and_forecast();
  const HorizonWind wind =
      horizon_wind(sea.data.wind, WindPolicy::forecast, end_of_day, stamps_to(72),
                   {UtcTime::max(), false, end_of_day + hours(7)});
  EXPECT_EQ(wind.source[7], DataStatus::analysis);
  EXPECT_EQ(wind.source[8], DataStatus::forecast);
  EXPECT_NEAR(std::abs(wind.wind_m_s[20] - rising(end_of_day + hours(20), 0) - 3.0), 0, 1e-12)
      << "the run of +6 h";
}

TEST(HorizonWind, TurningTheWindTurnsIt) {
  const Horizontal by(0, 1);
  for (const WindPolicy policy : all_policies) {
    KnownSeriesForTests sea = analysed_and_forecast();
    const auto made = [&] {
      return horizon_wind(sea.data.wind, policy, end_of_day, stamps_to(200)).wind_m_s;
    };
    const std::vector<Horizontal> straight = made();
    turn(sea.data.wind, by);
    const std::vector<Horizontal> turned = made();
    for (std::size_t h = 0; h < straight.size(); ++h)
      EXPECT_NEAR(std::abs(turned[h] - by * straight[h]), 0, 1e-12) << h;
  }
}

}  // namespace
}  // namespace slackwater::calibration::horizon_wind_test
