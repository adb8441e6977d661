// One part of a day that fails never stops the others: each is made to fail in turn, by a bug and
// by an error, and everything else is what it would be without that part.
#include "calibration/day/day_parts.h"

#include <gtest/gtest.h>

#include "calibration/day/daily_forecast.h"
#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::day_parts_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);

/// Two columns with a tide, wind and waves, and a past to rehearse.
struct TwoColumns {
  KnownSeriesForTests first = column(1.0);
  KnownSeriesForTests second = column(0.8);
  SiteData data = site_of({first.data, second.data});

  static KnownSeriesForTests column(double factor) {
    KnownSeriesForTests sea;
    sea.current(analysis_of("model", 11), instants(end_of_day - days(8), end_of_day), {2, 8},
                [=](UtcTime time, double depth) {
                  const double hour = hours_between(end_of_day, time);
                  return factor *
                         (Horizontal(0.1, 0.05) + std::polar(0.3 - 0.01 * depth, 0.506 * hour) +
                          std::polar(0.1, 0.02 * hour));
                });
    const auto time = instants(end_of_day - days(12), end_of_day + days(4));
    sea.wind(received(analysis_of("wind", 12), end_of_day), time, [](UtcTime at, double) {
      return std::polar(8.0, 0.02 * hours_between(end_of_day, at));
    });
    sea.waves(
        received(analysis_of("waves", 13), end_of_day), time, [](UtcTime) { return 1.5; },
        [](UtcTime) { return 6.0; }, [](UtcTime) { return 280.0; });
    return sea;
  }
};

const TwoColumns& sea() {
  static const TwoColumns made;
  return made;
}

DailyForecast forecast_with(const DayParts& parts) {
  ForecastOptions options;
  options.issued = end_of_day + hours(5);
  options.horizon = hours(24);
  options.threads = 2;
  options.parts = parts;
  return make_forecast(sea().data, options);
}

const DailyForecast& whole() {
  static const DailyForecast made = forecast_with({});
  return made;
}

void expect_same_currents(const ForecastColumn& a, const ForecastColumn& b) {
  EXPECT_EQ(a.current_m_s, b.current_m_s);
  EXPECT_EQ(a.current_sigma_m_s, b.current_sigma_m_s);
  EXPECT_EQ(a.current_status, b.current_status);
  EXPECT_EQ(a.member_m_s, b.member_m_s);
}

void expect_same_wind(const ForecastColumn& a, const ForecastColumn& b) {
  EXPECT_EQ(a.wind_m_s, b.wind_m_s);
  EXPECT_EQ(a.wind_source, b.wind_source);
  EXPECT_EQ(a.wind_member_m_s, b.wind_member_m_s);
}

void expect_same_sea(const ForecastColumn& a, const ForecastColumn& b) {
  ASSERT_EQ(a.sea.size(), b.sea.size());
  for (std::size_t t = 0; t < a.sea.size(); ++t) {
    EXPECT_EQ(a.sea[t].significant_height_m, b.sea[t].significant_height_m);
    EXPECT_EQ(a.sea[t].peak_period_s, b.sea[t].peak_period_s);
    EXPECT_EQ(a.sea[t].from_direction_deg, b.sea[t].from_direction_deg);
  }
  EXPECT_EQ(a.sea_source, b.sea_source);
}

/// To the last bit.
void expect_same(const DailyForecast& a, const DailyForecast& b) {
  ASSERT_EQ(a.snapshot.columns.size(), b.snapshot.columns.size());
  EXPECT_EQ(a.snapshot.time, b.snapshot.time);
  for (std::size_t c = 0; c < a.snapshot.columns.size(); ++c) {
    expect_same_currents(a.snapshot.columns[c], b.snapshot.columns[c]);
    expect_same_wind(a.snapshot.columns[c], b.snapshot.columns[c]);
    expect_same_sea(a.snapshot.columns[c], b.snapshot.columns[c]);
  }
}

void expect_named(const DailyForecast& made, const std::string& words) {
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_NE(made.snapshot.headline.find(words), std::string::npos)
      << words << " in: " << made.snapshot.headline;
  EXPECT_NE(made.snapshot.headline.find("broken for the test"), std::string::npos)
      << "and why: " << made.snapshot.headline;
}

bool is_first(const ColumnData& column) { return &column == &sea().data.columns.front(); }

/// The two ways in which a part breaks.
const std::vector<std::function<void()>> breaks{
    [] { expects(false, "broken for the test"); },
    [] { throw Error(ErrorKind::not_converged, "broken for the test"); }};

TEST(DayParts, WithNoneBrokenNothingIsNamed) {
  EXPECT_FALSE(whole().snapshot.degraded) << whole().snapshot.headline;
  EXPECT_TRUE(whole().earned);
  EXPECT_GE(whole().earned->blend.pairs, 5u);
}

TEST(DayParts, BrokenWavesCostTheWavesAndNothingElse) {
  for (const auto& how : breaks) {
    DayParts parts;
    parts.of_column.waves = [&](auto&&...) -> HorizonSea { return how(), HorizonSea{}; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he waves failed, none are forecast");
    for (std::size_t c = 0; c < 2; ++c) {
      EXPECT_TRUE(made.snapshot.columns[c].sea.empty());
      expect_same_currents(made.snapshot.columns[c], whole().snapshot.columns[c]);
      expect_same_wind(made.snapshot.columns[c], whole().snapshot.columns[c]);
    }
  }
}

TEST(DayParts, ABrokenWindIsAForecastWithoutAnyStoredWind) {
  DayParts without;
  without.of_column.wind = [](auto&&...) { return HorizonWind{}; };
  const DailyForecast expected = forecast_with(without);
  for (const auto& how : breaks) {
    DayParts parts;
    parts.of_column.wind = [&](auto&&...) -> HorizonWind { return how(), HorizonWind{}; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he wind failed, the wind and the wind-driven current are left out");
    EXPECT_EQ(made.snapshot.headline.find("No wind is stored"), std::string::npos)
        << "it is stored: " << made.snapshot.headline;
    expect_same(made, expected);
    expect_same_sea(made.snapshot.columns[0], whole().snapshot.columns[0]);
    EXPECT_EQ(made.snapshot.columns[0].current_status[0], SampleStatus::ok);
  }
}

TEST(DayParts, ABrokenMixedLayerIsAForecastWithoutThatOfTheProduct) {
  for (const auto& how : breaks) {
    DayParts parts;
    parts.of_column.mixed_layer = [&](auto&&...) -> LayerOfDays { return how(), LayerOfDays{}; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he product's mixed layer failed, it is not used");
    expect_same(made, whole());  // whose product says nothing of it
  }
}

TEST(DayParts, ABrokenTideIsAForecastOfARecordTooShortForOne) {
  DayParts without;
  without.of_column.tide = [](auto&&...) { return FittedTide{}; };
  const DailyForecast expected = forecast_with(without);
  for (const auto& how : breaks) {
    DayParts parts;
    parts.of_column.tide = [&](auto&&...) -> FittedTide { return how(), FittedTide{}; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he tide failed, it is left out of the current");
    expect_same(made, expected);
  }
}

/// At one column of two the current is missing, the wind and waves there and all of the other
/// column are as ever.
void expect_first_current_missing(const DailyForecast& made) {
  for (const SampleStatus status : made.snapshot.columns[0].current_status)
    EXPECT_EQ(status, SampleStatus::missing);
  EXPECT_TRUE(made.snapshot.columns[0].member_m_s.empty());
  EXPECT_EQ(made.snapshot.columns[0].wind_m_s, whole().snapshot.columns[0].wind_m_s);
  expect_same_sea(made.snapshot.columns[0], whole().snapshot.columns[0]);
  expect_same_sea(made.snapshot.columns[1], whole().snapshot.columns[1]);
  expect_same_wind(made.snapshot.columns[1], whole().snapshot.columns[1]);
  expect_same_currents(made.snapshot.columns[1], whole().snapshot.columns[1]);
}

TEST(DayParts, ABrokenRecordCalibrationOrPropagationAtOneColumnIsThatColumnsCurrent) {
  for (const auto& how : breaks) {
    const auto at_first_today = [&](const ColumnData& column, const ForecastPlan& plan) {
      if (is_first(column) && plan.day == day) how();
    };
    DayParts record;
    record.of_column.record = [&](const ColumnData& column, const ForecastPlan& plan) {
      at_first_today(column, plan);
      return known_currents(column, plan);
    };
    DayParts calibration;
    calibration.column = [&](const ColumnData& column, const Site& site, const ForecastPlan& plan,
                             const ColumnParts& parts) {
      ColumnParts ours = parts;
      if (is_first(column))
        ours.calibration = [&](auto&&...) -> ColumnCalibration {
          return how(), ColumnCalibration{};
        };
      return forecast_column(column, site, plan, ours);
    };
    DayParts propagation;
    propagation.column = [&](const ColumnData& column, const Site& site, const ForecastPlan& plan,
                             const ColumnParts& parts) {
      ColumnParts ours = parts;
      if (is_first(column))
        ours.propagation = [&](auto&&...) -> Propagated { return how(), Propagated{}; };
      return forecast_column(column, site, plan, ours);
    };
    for (const DayParts* parts : {&record, &calibration, &propagation}) {
      const DailyForecast made = forecast_with(*parts);
      expect_named(made, "1 of 2 columns are not calibrated");
      expect_first_current_missing(made);
      EXPECT_FALSE(made.columns[0].calibration_problem.empty());
    }
  }
}

TEST(DayParts, ABrokenColumnCostsItselfAlone) {
  for (const auto& how : breaks) {
    DayParts parts;
    parts.column = [&](const ColumnData& column, const Site& site, const ForecastPlan& plan,
                       const ColumnParts& ours) {
      if (is_first(column)) how();
      return forecast_column(column, site, plan, ours);
    };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he forecast failed at 1 of 2 columns, nothing is forecast there");
    const ForecastColumn& lost = made.snapshot.columns[0];
    EXPECT_EQ(lost.point, whole().snapshot.columns[0].point);
    EXPECT_TRUE(lost.wind_m_s.empty() && lost.sea.empty());
    EXPECT_EQ(lost.current_status.size(), whole().snapshot.columns[0].current_status.size());
    for (const SampleStatus status : lost.current_status) EXPECT_EQ(status, SampleStatus::missing);
    expect_same_currents(made.snapshot.columns[1], whole().snapshot.columns[1]);
    expect_same_wind(made.snapshot.columns[1], whole().snapshot.columns[1]);
    expect_same_sea(made.snapshot.columns[1], whole().snapshot.columns[1]);
  }
}

TEST(DayParts, ABrokenRehearsalLeavesOurOwnForecast) {
  DayParts unblended;
  unblended.blend = [](auto&&...) {};
  const DailyForecast expected = forecast_with(unblended);
  for (const auto& how : breaks) {
    DayParts parts;
    parts.rehearsal = [&](auto&&...) -> Earned { return how(), Earned{}; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he rehearsal of past days failed, our own forecast is issued");
    expect_same(made, expected);
    EXPECT_FALSE(made.earned);
  }
}

TEST(DayParts, ABlendThatBreaksHalfWayLeavesTheColumnAsItWas) {
  DayParts unblended;
  unblended.blend = [](ForecastColumn& column, const ColumnData& data, const KnownColumn& known,
                       const ForecastPlan& plan, const Earned& earned) {
    if (!is_first(data)) issue_blend(column, data, known, plan, earned);
  };
  const DailyForecast expected = forecast_with(unblended);
  for (const auto& how : breaks) {
    DayParts parts;
    parts.blend = [&](ForecastColumn& column, const ColumnData& data, const KnownColumn& known,
                      const ForecastPlan& plan, const Earned& earned) {
      issue_blend(column, data, known, plan, earned);
      if (is_first(data)) how();
    };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he blend failed at 1 of 2 columns, our own forecast is issued");
    expect_same(made, expected);
    expect_same_currents(made.snapshot.columns[1], whole().snapshot.columns[1]);
  }
}

TEST(DayParts, ABrokenPastDayIsNamedAndTheOthersDecide) {
  DayParts parts;
  parts.of_column.record = [](const ColumnData& column, const ForecastPlan& plan) {
    expects(plan.day != day - days(2), "broken for the test");
    return known_currents(column, plan);
  };
  const DailyForecast made = forecast_with(parts);
  expect_named(made, "he rehearsal of 1 past day failed; the blend uses the others");
  EXPECT_EQ(made.earned->blend.pairs, whole().earned->blend.pairs - 1);
}

TEST(DayParts, WithoutADayWindAndWavesStandAlone) {
  for (const auto& how : breaks) {
    DayParts parts;
    parts.day = [&](auto&&...) -> std::optional<LeadingDay> { return how(), std::nullopt; };
    const DailyForecast made = forecast_with(parts);
    expect_named(made, "he choice of the day failed, no current is forecast");
    EXPECT_EQ(made.snapshot.headline.find("is stored"), std::string::npos)
        << "nothing is missing from the store: " << made.snapshot.headline;
    EXPECT_TRUE(made.snapshot.columns[0].current_m_s.empty());
    EXPECT_EQ(made.snapshot.columns[0].wind_m_s.size(), made.snapshot.time.size());
    EXPECT_EQ(made.snapshot.columns[0].sea.size(), made.snapshot.time.size());
  }
}

TEST(DayParts, TwoThatBreakAreBothNamed) {
  DayParts parts;
  parts.of_column.waves = [](auto&&...) -> HorizonSea { return breaks[0](), HorizonSea{}; };
  parts.of_column.tide = [](auto&&...) -> FittedTide { return breaks[1](), FittedTide{}; };
  const DailyForecast made = forecast_with(parts);
  expect_named(made, "he waves failed");
  expect_named(made, "he tide failed");
}

TEST(DayParts, AForecastOfNothingIsAnErrorAndDoesNotReplaceTheLastOne) {
  for (const auto& how : breaks) {
    DayParts parts;
    parts.column = [&](auto&&...) -> ColumnForecast { return how(), ColumnForecast{}; };
    try {
      (void)forecast_with(parts);
      FAIL() << "nothing was forecast";
    } catch (const Error& error) {
      EXPECT_NE(error.message().find("nothing can be forecast"), std::string::npos);
      EXPECT_NE(error.message().find("broken for the test"), std::string::npos) << error.message();
      EXPECT_NE(error.kind(), ErrorKind::not_found) << "the data are there";
    }
  }
}

}  // namespace
}  // namespace slackwater::calibration::day_parts_test
