#include "calibration/day/forecast_column.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::forecast_column_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);
const std::vector<double> depth_m{2, 8, 20};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

ForecastPlan plan_to(int lead_h, WindPolicy wind = WindPolicy::best) {
  ForecastPlan plan;
  plan.day = day;
  plan.issued = end_of_day + hours(5);
  plan.wind = wind;
  plan.dataset = "model";
  plan.depth_m = depth_m;
  for (int h = 0; h <= lead_h; ++h) plan.stamps.push_back(end_of_day + hours(h));
  return plan;
}

/// M2: 12.4206012 h.
constexpr double m2_rad_h = 2 * std::numbers::pi / 12.4206012;

Horizontal tide(UtcTime time) {
  const double phase = m2_rad_h * hours_between(UtcTime(day), time);
  return {0.5 * std::cos(phase), 0.2 * std::sin(phase)};
}

/// A turning wind.
Horizontal blow(UtcTime time, double) {
  const double hour = hours_between(UtcTime(day), time);
  return std::polar(8 + 2 * std::sin(0.2 * hour), 0.6 + 0.03 * hour);
}

/// A made-up sea with all that a day can have: drift, shear, a slow oscillation, wind; analysed for
/// two days beyond D, forecast by runs before and after the end of D.
KnownSeriesForTests busy_sea() {
  KnownSeriesForTests sea;
  const auto flow = [](UtcTime time, double depth) {
    const double hour = hours_between(UtcTime(day), time);
    return Horizontal(0.2, -0.1) + std::polar(0.12 * std::exp(-depth / 15), -0.42 * hour) +
           std::polar(0.05, 0.09 * hour);
  };
  sea.current(analysis_of("model"), instants(UtcTime(day) - days(4), end_of_day + days(2)), depth_m,
              flow);
  sea.wind(analysis_of("wind"), instants(UtcTime(day) - days(7), end_of_day + days(2)), blow);
  for (const int issued_h : {-12, 3, 12}) {
    const UtcTime issued = end_of_day + hours(issued_h);
    sea.wind(forecast_of("wind", issued), instants(issued, issued + days(4)),
             [=](UtcTime time, double) { return blow(time, 0) + 0.1 * issued_h; });
  }
  return sea;
}

TEST(ForecastColumn, ASteadySeaWithoutWindStaysAsItIs) {
  // Two days are too short for a tide. Of what a level remembers the kernel takes 4 % for slow
  // change, which may fade.
  const Horizontal interior(0.25, -0.15);
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(2), end_of_day), depth_m,
              steady(interior));
  const ColumnForecast made = forecast_column(sea.data, {}, plan_to(48));
  ASSERT_EQ(made.column.current_m_s.size(), 49 * depth_m.size());
  for (std::size_t i = 0; i < made.column.current_m_s.size(); ++i) {
    EXPECT_EQ(made.column.current_status[i], SampleStatus::ok);
    EXPECT_LT(std::abs(made.column.current_m_s[i] - interior), 0.04 * std::abs(interior)) << i;
    EXPECT_GT(made.column.current_sigma_m_s[i], 0) << "nobody is sure of tomorrow";
  }
  EXPECT_TRUE(made.column.wind_m_s.empty());
}

TEST(ForecastColumn, ATideAloneIsForecastAsThatTide) {
  // Over 27.6 days M2 stands by itself; what it leaves unexplained is rounding.
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(32), end_of_day), depth_m,
              [](UtcTime time, double) { return tide(time); });
  const ForecastPlan plan = plan_to(72);
  const ColumnForecast made = forecast_column(sea.data, {}, plan);
  ASSERT_EQ(made.column.current_m_s.size(), 73 * depth_m.size());
  for (std::size_t i = 0; i < made.column.current_m_s.size(); ++i) {
    const Horizontal expected = tide(plan.stamps[i / depth_m.size()]);
    EXPECT_LT(std::abs(made.column.current_m_s[i] - expected), 1e-6) << i;
  }
}

TEST(ForecastColumn, TurningTheSeaAndItsWindTurnsTheForecast) {
  const Horizontal by(0, 1);
  KnownSeriesForTests sea = busy_sea();
  const ColumnForecast straight = forecast_column(sea.data, {}, plan_to(24));
  turn(sea.data.current, by);
  turn(sea.data.wind, by);
  const ColumnForecast turned = forecast_column(sea.data, {}, plan_to(24));
  ASSERT_FALSE(straight.forms.empty()) << straight.calibration_problem;
  ASSERT_EQ(turned.column.current_m_s.size(), straight.column.current_m_s.size());
  for (std::size_t i = 0; i < turned.column.current_m_s.size(); ++i) {
    const Horizontal expected = by * straight.column.current_m_s[i];
    EXPECT_LT(std::abs(turned.column.current_m_s[i] - expected), 1e-9) << "rounding " << i;
  }
  EXPECT_EQ(turned.best_form, straight.best_form);
}

void expect_same(const ColumnForecast& a, const ColumnForecast& b) {
  EXPECT_EQ(a.column.current_m_s, b.column.current_m_s);
  EXPECT_EQ(a.column.current_sigma_m_s, b.column.current_sigma_m_s);
  EXPECT_EQ(a.column.current_status, b.column.current_status);
  EXPECT_EQ(a.column.member_m_s, b.column.member_m_s);
  EXPECT_EQ(a.column.wind_m_s, b.column.wind_m_s);
  EXPECT_EQ(a.column.wind_source, b.column.wind_source);
  EXPECT_EQ(a.column.wind_member_m_s, b.column.wind_member_m_s);
  EXPECT_EQ(a.form_weight, b.form_weight);
  EXPECT_EQ(a.notes, b.notes);
  EXPECT_EQ(a.origins, b.origins);
}

TEST(ForecastColumn, UnderForecastWindNothingLaterThanTheDayMatters) {
  const KnownSeriesForTests sea = busy_sea();
  const ForecastPlan plan = plan_to(36, WindPolicy::forecast);
  const ColumnForecast made = forecast_column(sea.data, {}, plan);
  EXPECT_EQ(made.column.wind_source.back(), DataStatus::forecast);
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, end_of_day, end_of_day);
  expect_same(forecast_column(spoilt, {}, plan), made);
}

TEST(ForecastColumn, UnderPersistedWindNothingLaterThanTheDayMatters) {
  const KnownSeriesForTests sea = busy_sea();
  const ForecastPlan plan = plan_to(36, WindPolicy::persist);
  const ColumnForecast made = forecast_column(sea.data, {}, plan);
  EXPECT_EQ(made.column.wind_source.back(), DataStatus::persisted);
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, end_of_day, plan.issued);
  expect_same(forecast_column(spoilt, {}, plan), made);
  spoil_all_after(spoilt, end_of_day);
  const ColumnForecast without_forecasts = forecast_column(spoilt, {}, plan);
  EXPECT_EQ(without_forecasts.column.current_m_s, made.column.current_m_s);
  EXPECT_EQ(without_forecasts.column.wind_m_s, made.column.wind_m_s);
  EXPECT_EQ(without_forecasts.column.current_sigma_m_s, made.column.current_sigma_m_s)
      << "the wind's climate is that of the record, which ends with D";
  EXPECT_EQ(without_forecasts.column.member_m_s, made.column.member_m_s);
  EXPECT_EQ(without_forecasts.column.wind_member_m_s, made.column.wind_member_m_s);
}

TEST(ForecastColumn, UnderBestWindLaterCurrentsStillDoNotMatterButLaterWindDoes) {
  const KnownSeriesForTests sea = busy_sea();
  const ColumnForecast made = forecast_column(sea.data, {}, plan_to(24));
  ColumnData later_currents = sea.data;
  spoil_all_after(later_currents, end_of_day);
  const ColumnData spoilt = later_currents;
  later_currents.wind = sea.data.wind;
  expect_same(forecast_column(later_currents, {}, plan_to(24)), made);
  EXPECT_NE(forecast_column(spoilt, {}, plan_to(24)).column.current_m_s, made.column.current_m_s);
}

TEST(ForecastColumn, TheSeedDrawsTheMembersAndNothingElse) {
  const KnownSeriesForTests sea = busy_sea();
  ForecastPlan plan = plan_to(12);
  const ColumnForecast first = forecast_column(sea.data, {}, plan);
  expect_same(forecast_column(sea.data, {}, plan), first);
  plan.seed = 2;
  const ColumnForecast second = forecast_column(sea.data, {}, plan);
  EXPECT_NE(second.column.member_m_s, first.column.member_m_s);
  const std::size_t values = first.column.current_m_s.size();
  ASSERT_EQ(first.column.member_m_s.size(), values * static_cast<std::size_t>(plan.spread.members));
  for (std::size_t i = 0; i < values; ++i) {
    Horizontal sum{};
    for (std::size_t m = i; m < first.column.member_m_s.size(); m += values)
      sum += first.column.member_m_s[m] - first.column.current_m_s[i];
    EXPECT_LT(std::abs(sum) / plan.spread.members, first.column.current_sigma_m_s[i])
        << "members stand around the centre";
  }
}

TEST(ForecastColumn, LevelsBelowTheBedAreSaidToBeThere) {
  KnownSeriesForTests sea = busy_sea();
  VectorColumn& column = sea.data.current.pieces[0].column;
  for (std::size_t t = 0; t < column.times(); ++t)
    column.status[column.offset(t, 2)] = SampleStatus::below_bed;
  const ColumnForecast made = forecast_column(sea.data, {}, plan_to(6));
  for (std::size_t t = 0; t < 7; ++t) {
    EXPECT_EQ(made.column.current_status[3 * t], SampleStatus::ok);
    EXPECT_EQ(made.column.current_status[3 * t + 2], SampleStatus::below_bed);
  }
  ForecastPlan deeper = plan_to(6);
  deeper.depth_m = {2, 8, 20, 50};
  EXPECT_EQ(forecast_column(sea.data, {}, deeper).column.current_status[3], SampleStatus::below_bed)
      << "the column has fewer levels than the plan";
}

TEST(ForecastColumn, WithoutCurrentsOnTheDayThereIsAReasonAndStillAWind) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(UtcTime(day) - days(4), UtcTime(day) - hours(1)),
              depth_m, steady({0.2, 0}));
  sea.wind(analysis_of("wind"), instants(UtcTime(day) - days(7), end_of_day), blow);
  const ColumnForecast made = forecast_column(sea.data, {}, plan_to(6));
  EXPECT_EQ(made.calibration_problem, "no currents of 2024-06-11 at this column");
  EXPECT_EQ(made.calibration(), nullptr);
  EXPECT_EQ(made.column.current_status,
            std::vector<SampleStatus>(7 * depth_m.size(), SampleStatus::missing));
  EXPECT_EQ(made.column.wind_m_s.size(), 7u);
  EXPECT_EQ(made.column.sea.size(), 7u);
}

TEST(ForecastColumn, ADayOfNothingButHolesIsNotForecast) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(UtcTime(day) - days(4), end_of_day), depth_m,
              [](UtcTime time, double) {
                return time < UtcTime(day) ? Horizontal(0.2, 0) : Horizontal(nan, nan);
              });
  const ColumnForecast made = forecast_column(sea.data, {}, plan_to(6));
  EXPECT_TRUE(made.forms.empty());
  for (const SampleStatus status : made.column.current_status) EXPECT_FALSE(has_value(status));
}

TEST(ForecastColumn, StokesDriftInTheRecordIsPassedOn) {
  KnownSeriesForTests sea;
  Origin origin = analysis_of("model");
  EXPECT_FALSE(forecast_column(busy_sea().data, {}, plan_to(1)).contains_stokes);
  origin.contains_stokes = true;
  sea.current(origin, instants(end_of_day - days(2), end_of_day), depth_m, steady({0.2, 0}));
  EXPECT_TRUE(forecast_column(sea.data, {}, plan_to(1)).contains_stokes);
}

}  // namespace
}  // namespace slackwater::calibration::forecast_column_test
