#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/day/daily_forecast.h"
#include "calibration/day/given/whole_day.h"
#include "calibration/day/leading_day.h"
#include "fields/base/error.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::daily_forecast_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using std::chrono::minutes;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime midnight(day);
const UtcTime end_of_day = midnight + days(1);
const UtcTime five_o_clock = end_of_day + hours(5);
const std::vector<double> depth_m{2, 8};
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

VectorColumn series(const std::vector<TimeCell>& time) {
  static const Origin origin = analysis_of("model");
  return vector_piece(origin, time, {5.0}, steady({0.1, 0})).column;
}

/// Without the cells whose centre lies within (from, to).
std::vector<TimeCell> without(std::vector<TimeCell> time, UtcTime from, UtcTime to) {
  std::erase_if(time, [&](const TimeCell& c) { return from < c.centre() && c.centre() < to; });
  return time;
}

TEST(HoldsThroughout, AWholeDayOfAnyStep) {
  for (const Duration step : {Duration(minutes(10)), Duration(hours(1)), Duration(hours(3)),
                              Duration(hours(6)), Duration(hours(12))}) {
    EXPECT_TRUE(holds_throughout(series(instants(midnight, end_of_day, step)), day));
    EXPECT_TRUE(holds_throughout(series(means(midnight, end_of_day, step)), day));
  }
  EXPECT_TRUE(holds_throughout(series(means(midnight, end_of_day, days(1))), day)) << "one mean";
}

TEST(HoldsThroughout, NothingOfTheDayIsNotTheDay) {
  EXPECT_FALSE(holds_throughout(series({}), day));
  EXPECT_FALSE(holds_throughout(series(instants(midnight - days(1), midnight - hours(1))), day));
  EXPECT_FALSE(holds_throughout(series({TimeCell::instant(midnight + hours(12))}), day));
  VectorColumn holes = series(instants(midnight, end_of_day));
  std::fill(holes.status.begin(), holes.status.end(), SampleStatus::missing);
  EXPECT_FALSE(holds_throughout(holes, day)) << "times without values";
}

TEST(HoldsThroughout, AGapOfTwoAndAHalfStepsIsTheWidest) {
  const auto hourly = instants(midnight, end_of_day);
  const UtcTime at = midnight + hours(7);
  EXPECT_TRUE(holds_throughout(series(without(hourly, at, at + hours(2))), day));
  EXPECT_FALSE(holds_throughout(series(without(hourly, at, at + hours(3))), day));
  const auto three_hourly = instants(midnight, end_of_day, hours(3));
  const UtcTime then = midnight + hours(6);
  EXPECT_TRUE(holds_throughout(series(without(three_hourly, then, then + hours(6))), day));
  EXPECT_FALSE(holds_throughout(series(without(three_hourly, then, then + hours(9))), day));
}

TEST(HoldsThroughout, InstrumentsFinerThanHourlyAreHeldToAnHourlySeries) {
  const auto fine = instants(midnight, end_of_day, minutes(10));
  const UtcTime at = midnight + hours(7);
  EXPECT_TRUE(holds_throughout(series(without(fine, at, at + minutes(150))), day));
  EXPECT_FALSE(holds_throughout(series(without(fine, at, at + minutes(160))), day));
}

TEST(HoldsThroughout, TheEndsOfTheDayCountToo) {
  EXPECT_TRUE(holds_throughout(series(instants(midnight + hours(1), end_of_day - hours(1))), day));
  EXPECT_FALSE(holds_throughout(series(instants(midnight + hours(2), end_of_day)), day));
  EXPECT_FALSE(holds_throughout(series(instants(midnight, end_of_day - hours(2))), day));
}

/// Hourly currents: a tide that falls off with depth, over a drift.
KnownSeriesForTests sea_until(UtcTime last, int past_days = 5) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model", 11), instants(last - days(past_days), last), depth_m,
              [](UtcTime time, double depth) {
                const double hour = hours_between(midnight, time);
                return Horizontal(0.1, 0.05) + std::polar(0.3 - 0.01 * depth, 0.506 * hour);
              });
  return sea;
}

void add_wind_and_waves(KnownSeriesForTests& sea, UtcTime last = end_of_day + days(10)) {
  const auto time = instants(end_of_day - days(12), last);
  Origin wind = analysis_of("wind", 12);
  Origin waves = analysis_of("waves", 13);
  wind.received = waves.received = end_of_day - days(12);  // products that run on into the future
  sea.wind(wind, time,
           [](UtcTime at, double) { return std::polar(8.0, 0.02 * hours_between(midnight, at)); });
  sea.waves(
      waves, time, [](UtcTime) { return 1.5; }, [](UtcTime) { return 6.0; },
      [](UtcTime) { return 280.0; });
}

ForecastOptions at_five(std::optional<UtcDay> wanted = std::nullopt, int horizon_h = 24) {
  ForecastOptions options;
  options.day = wanted;
  options.issued = five_o_clock;
  options.horizon = hours(horizon_h);
  return options;
}

bool says(const Snapshot& snapshot, const std::string& text) {
  return snapshot.headline.find(text) != std::string::npos;
}

std::optional<UtcDay> newest_whole_day(const SiteData& data, UtcTime issued) {
  const auto leading = leading_day(data, {issued});
  return leading ? std::optional(leading->day) : std::nullopt;
}

TEST(NewestWholeDay, IsTheLastDayThatIsOverAndWhole) {
  const KnownSeriesForTests sea = sea_until(end_of_day + hours(4));
  const SiteData data = site_of({sea.data});
  EXPECT_EQ(newest_whole_day(data, five_o_clock), day);
  EXPECT_EQ(newest_whole_day(data, end_of_day), day) << "at midnight it is over";
  EXPECT_EQ(newest_whole_day(data, end_of_day - Duration(1)), day - days(1));
  EXPECT_TRUE(holds_day(data, "model", day, {five_o_clock}));
  EXPECT_FALSE(holds_day(data, "model", day + days(1), {five_o_clock}));
}

TEST(NewestWholeDay, PassesOverDaysWithGaps) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  VectorColumn& column = sea.data.current.pieces[0].column;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].centre() < midnight + hours(9)) continue;
    for (std::size_t k = 0; k < column.levels(); ++k)
      column.status[column.offset(t, k)] = SampleStatus::missing;
  }
  EXPECT_EQ(newest_whole_day(site_of({sea.data}), five_o_clock), day - days(1));
}

TEST(NewestWholeDay, IsNoneWithoutCurrents) {
  KnownSeriesForTests sea;
  EXPECT_EQ(newest_whole_day(site_of({sea.data}), five_o_clock), std::nullopt);
  EXPECT_EQ(newest_whole_day(site_of({sea_until(end_of_day - days(3), 0).data}), five_o_clock),
            std::nullopt)
      << "a lone instant";
}

TEST(NewestWholeDay, CountsADayThatIsForecastAsFarAsItWasIssued) {
  KnownSeriesForTests sea = sea_until(midnight);
  sea.current(forecast_of("model", midnight), instants(midnight, midnight + days(5)), depth_m,
              steady({0.1, 0}));
  EXPECT_EQ(newest_whole_day(site_of({sea.data}), five_o_clock), day);
  EXPECT_EQ(newest_whole_day(site_of({sea.data}), midnight), day - days(1));
}

TEST(MakeForecast, RunsFromTheEndOfTheDayToTheHorizon) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea);
  const DailyForecast made = make_forecast(site_of({sea.data}), at_five());
  const Snapshot& snapshot = made.snapshot;
  EXPECT_EQ(snapshot.day, day);
  EXPECT_EQ(snapshot.issued, five_o_clock);
  EXPECT_FALSE(snapshot.degraded) << snapshot.headline;
  EXPECT_EQ(snapshot.headline,
            "Currents calibrated on 2024-06-11, forecast to 2024-06-13T00:00:00Z.");
  ASSERT_EQ(snapshot.time.size(), 25u);
  EXPECT_EQ(snapshot.time.front(), end_of_day);
  EXPECT_EQ(snapshot.time.back(), end_of_day + days(1));
  EXPECT_EQ(snapshot.depth_m, depth_m);
  EXPECT_EQ(made.plan.dataset, "model");
  EXPECT_EQ(made.input_granules, (std::vector<std::int64_t>{11, 12, 13}));
  ASSERT_EQ(snapshot.columns.size(), 1u);
  const ForecastColumn& column = snapshot.columns[0];
  EXPECT_EQ(column.current_m_s.size(), 25 * depth_m.size());
  EXPECT_EQ(column.wind_m_s.size(), 25u);
  EXPECT_EQ(column.sea.size(), 25u);
  EXPECT_EQ(column.member_m_s.size(), (snapshot.members - 1) * column.current_m_s.size());
  EXPECT_TRUE(made.earned);
}

TEST(MakeForecast, FallsBackOnTheLastGoodDayAndSaysSo) {
  KnownSeriesForTests sea = sea_until(midnight + hours(10));
  add_wind_and_waves(sea);
  const Snapshot snapshot = make_forecast(site_of({sea.data}), at_five(day)).snapshot;
  EXPECT_EQ(snapshot.day, day - days(1));
  EXPECT_TRUE(snapshot.degraded);
  EXPECT_TRUE(says(snapshot, "2024-06-11 are missing or incomplete")) << snapshot.headline;
  EXPECT_TRUE(says(snapshot, "the last good day, 2024-06-10, is used")) << snapshot.headline;
  EXPECT_EQ(snapshot.time.front(), midnight) << "lead counts from the end of the day used";
  EXPECT_EQ(snapshot.time.back(), end_of_day + days(1)) << "and reaches as far as was asked";
}

TEST(MakeForecast, TheLongerLeadOfAnOlderDayHasTheWiderBand) {
  const auto width_at_noon_of_tomorrow = [&](UtcTime last) {
    KnownSeriesForTests known = sea_until(last);
    add_wind_and_waves(known);
    const DailyForecast made = make_forecast(site_of({known.data}), at_five(day));
    const auto found =
        std::find(made.snapshot.time.begin(), made.snapshot.time.end(), end_of_day + hours(12));
    const auto t = static_cast<std::size_t>(found - made.snapshot.time.begin());
    return made.snapshot.columns[0].current_sigma_m_s[t * depth_m.size()] /
           made.earned->spread.scale_at(
               hours_between(made.snapshot.time.front(), made.snapshot.time[t]));
  };
  EXPECT_GT(width_at_noon_of_tomorrow(midnight - days(1)), width_at_noon_of_tomorrow(end_of_day));
}

TEST(MakeForecast, AProviderThatIsADayLateIsUsualMoreThanThatIsNot) {
  for (const int late_days : {0, 1, 2}) {
    KnownSeriesForTests sea = sea_until(end_of_day - days(late_days));
    add_wind_and_waves(sea);
    const Snapshot snapshot = make_forecast(site_of({sea.data}), at_five()).snapshot;
    EXPECT_EQ(snapshot.day, day - days(late_days));
    EXPECT_EQ(snapshot.degraded, late_days > 1) << snapshot.headline;
    EXPECT_EQ(snapshot.time.front(), end_of_day - days(late_days));
    EXPECT_EQ(snapshot.time.back(), end_of_day + days(late_days == 0 ? 1 : 0));
  }
}

TEST(MakeForecast, WithoutCurrentsWindAndWavesStandAlone) {
  KnownSeriesForTests sea;
  add_wind_and_waves(sea);
  const DailyForecast made = make_forecast(site_of({sea.data}), at_five(day));
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_TRUE(says(made.snapshot, "only wind and waves are forecast")) << made.snapshot.headline;
  EXPECT_TRUE(made.plan.dataset.empty());
  EXPECT_FALSE(made.earned);
  EXPECT_TRUE(made.snapshot.depth_m.empty());
  const ForecastColumn& column = made.snapshot.columns.at(0);
  EXPECT_TRUE(column.current_m_s.empty()) << "no value, not calm water";
  ASSERT_EQ(column.wind_m_s.size(), 25u);
  ASSERT_EQ(column.sea.size(), 25u);
  EXPECT_NEAR(std::abs(column.wind_m_s[3]), 8, 1e-12);
  EXPECT_NEAR(column.sea[3].significant_height_m, 1.5, 1e-12);
  EXPECT_EQ(made.input_granules, (std::vector<std::int64_t>{12, 13}));
}

TEST(MakeForecast, WithoutWindTheHeadlineSaysWhatIsLeftOut) {
  const KnownSeriesForTests sea = sea_until(end_of_day);
  const Snapshot snapshot = make_forecast(site_of({sea.data}), at_five()).snapshot;
  EXPECT_TRUE(snapshot.degraded);
  EXPECT_TRUE(says(snapshot, "No wind is stored")) << snapshot.headline;
  EXPECT_TRUE(snapshot.columns[0].wind_m_s.empty());
  EXPECT_EQ(snapshot.columns[0].current_status[0], SampleStatus::ok);
}

TEST(MakeForecast, WindThatIsMostlyPersistedIsATroubleUnlessItWasAskedFor) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea, end_of_day + hours(3));
  ForecastOptions options = at_five();
  const Snapshot best = make_forecast(site_of({sea.data}), options).snapshot;
  EXPECT_TRUE(best.degraded);
  EXPECT_TRUE(says(best, "he last known wind is used for 21 of 25 hours")) << best.headline;
  options.wind = WindPolicy::persist;
  EXPECT_FALSE(make_forecast(site_of({sea.data}), options).snapshot.degraded);
}

TEST(MakeForecast, ACurrentOfLongAgoIsNotFound) {
  KnownSeriesForTests sea = sea_until(end_of_day - days(45));
  add_wind_and_waves(sea);
  try {
    (void)make_forecast(site_of({sea.data}), at_five(day));
    FAIL() << "more than forty days of lead are no forecast";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    EXPECT_NE(error.message().find("2024-04-27"), std::string::npos) << "names the day it has";
    EXPECT_NE(error.message().find("2024-06-11"), std::string::npos) << "and the day it wants";
    EXPECT_NE(error.message().find("more than 40 days"), std::string::npos) << error.message();
  }
}

TEST(MakeForecast, NamesWhatItRestsOn) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea);
  const SiteData data = site_of({sea.data});
  ForecastOptions options = at_five();
  options.code_version = "0.1.0+made-up";
  const DailyForecast made = make_forecast(data, options);
  const Provenance& provenance = made.snapshot.provenance;
  EXPECT_EQ(provenance.site, data.site.id);
  EXPECT_EQ(provenance.issued, options.issued);
  EXPECT_EQ(provenance.code_version, "0.1.0+made-up");
  EXPECT_FALSE(provenance.inputs.empty());
  EXPECT_TRUE(std::is_sorted(provenance.inputs.begin(), provenance.inputs.end(),
                             [](const auto& a, const auto& b) { return a.product < b.product; }));
  ASSERT_TRUE(provenance.calibration);
  const Calibration& fitted = *made.columns.front().calibration();
  EXPECT_EQ(provenance.calibration->form, name_of(fitted.form));
  EXPECT_EQ(provenance.calibration->rms_m_s, fitted.rms_m_s);
  EXPECT_EQ(provenance.calibration->parameters.size(), fitted.parameters.size());
}

TEST(MakeForecast, AColumnOfNothingButHolesOnTheDayIsSaidToBeThat) {
  KnownSeriesForTests whole = sea_until(end_of_day);
  add_wind_and_waves(whole);
  KnownSeriesForTests holes = sea_until(end_of_day);
  VectorColumn& column = holes.data.current.pieces[0].column;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].centre() < midnight) continue;
    for (std::size_t k = 0; k < column.levels(); ++k)
      column.status[column.offset(t, k)] = SampleStatus::missing;
  }
  const Snapshot snapshot = make_forecast(site_of({whole.data, holes.data}), at_five()).snapshot;
  EXPECT_TRUE(snapshot.degraded);
  EXPECT_TRUE(says(snapshot,
                   "1 of 2 columns are not calibrated: no currents of 2024-06-11 at this "
                   "column"))
      << snapshot.headline;
}

void expect_same(const DailyForecast& a, const DailyForecast& b) {
  ASSERT_EQ(a.snapshot.columns.size(), b.snapshot.columns.size());
  for (std::size_t c = 0; c < a.snapshot.columns.size(); ++c) {
    EXPECT_EQ(a.snapshot.columns[c].current_m_s, b.snapshot.columns[c].current_m_s);
    EXPECT_EQ(a.snapshot.columns[c].current_sigma_m_s, b.snapshot.columns[c].current_sigma_m_s);
    EXPECT_EQ(a.snapshot.columns[c].current_status, b.snapshot.columns[c].current_status);
    EXPECT_EQ(a.snapshot.columns[c].member_m_s, b.snapshot.columns[c].member_m_s);
    EXPECT_EQ(a.snapshot.columns[c].wind_m_s, b.snapshot.columns[c].wind_m_s);
    EXPECT_EQ(a.snapshot.columns[c].wind_member_m_s, b.snapshot.columns[c].wind_member_m_s);
  }
  EXPECT_EQ(a.snapshot.headline, b.snapshot.headline);
  EXPECT_EQ(a.input_granules, b.input_granules);
}

TEST(MakeForecast, UnderForecastWindNothingAfterTheDayMatters) {
  KnownSeriesForTests sea = sea_until(end_of_day + days(2), 8);
  add_wind_and_waves(sea, end_of_day);
  sea.wind(forecast_of("wind", end_of_day - hours(12), 14),
           instants(end_of_day - hours(12), end_of_day + days(4)), steady({6, 3}));
  sea.wind(forecast_of("wind", end_of_day + hours(6), 15),
           instants(end_of_day + hours(6), end_of_day + days(4)), steady({-6, 3}));
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, end_of_day, end_of_day);
  ForecastOptions options = at_five(day);
  options.wind = WindPolicy::forecast;
  expect_same(make_forecast(site_of({spoilt}), options),
              make_forecast(site_of({sea.data}), options));
}

/// Analysed for two days beyond D, forecast by runs of before and after five o'clock.
KnownSeriesForTests sea_of_a_replay() {
  KnownSeriesForTests sea = sea_until(end_of_day + days(2), 8);
  const auto analysed = instants(end_of_day - days(12), end_of_day + days(2));
  sea.wind(analysis_of("wind", 12), analysed,
           [](UtcTime at, double) { return std::polar(8.0, 0.02 * hours_between(midnight, at)); });
  for (const int issued_h : {-6, 6}) {
    const UtcTime issued = end_of_day + hours(issued_h);
    sea.wind(forecast_of("wind", issued, 20 + issued_h), instants(issued, issued + days(4)),
             steady({double(issued_h), 3}));
  }
  sea.waves(
      analysis_of("waves", 13), analysed, [](UtcTime) { return 1.5; }, [](UtcTime) { return 6.0; },
      [](UtcTime) { return 280.0; });
  return sea;
}

TEST(MakeForecast, NothingThatWasNotKnownAtTheIssueTimeMattersUnderAnyWindPolicy) {
  const KnownSeriesForTests sea = sea_of_a_replay();
  ColumnData spoilt = sea.data;
  spoil_after(spoilt, five_o_clock, five_o_clock);
  for (const WindPolicy wind : {WindPolicy::best, WindPolicy::forecast, WindPolicy::persist}) {
    ForecastOptions options = at_five(day);
    options.wind = wind;
    const DailyForecast made = make_forecast(site_of({sea.data}), options);
    EXPECT_FALSE(made.snapshot.hindsight);
    expect_same(make_forecast(site_of({spoilt}), options), made);
  }
}

TEST(MakeForecast, AProductThatBeginsLaterDoesNotSilenceTheStationOfToday) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  sea.wind(station_of("mast", 9), instants(end_of_day - days(12), end_of_day), steady({7, 1}));
  const DailyForecast today = make_forecast(site_of({sea.data}), at_five(day));
  sea.wind(analysis_of("wind", 12), instants(five_o_clock + hours(1), end_of_day + days(2)),
           steady({20, 0}));
  expect_same(make_forecast(site_of({sea.data}), at_five(day)), today);
}

TEST(MakeForecast, HindsightUsesWhatCameLaterAndSaysSo) {
  const KnownSeriesForTests sea = sea_of_a_replay();
  ForecastOptions options = at_five(day);
  options.hindsight = true;
  const DailyForecast made = make_forecast(site_of({sea.data}), options);
  EXPECT_TRUE(made.snapshot.hindsight);
  EXPECT_FALSE(made.snapshot.degraded);
  EXPECT_TRUE(says(made.snapshot, "Made in hindsight")) << made.snapshot.headline;
  EXPECT_TRUE(says(made.snapshot, "2024-06-12T05:00:00Z")) << made.snapshot.headline;
  const auto& notes = made.columns.front().notes;
  EXPECT_TRUE(std::any_of(notes.begin(), notes.end(), [](const std::string& note) {
    return note.find("hindsight") != std::string::npos;
  }));
  const std::vector<DataStatus>& source = made.snapshot.columns[0].wind_source;
  EXPECT_EQ(source.back(), DataStatus::analysis);
}

TEST(MakeForecast, HindsightThatFoundNothingLaterIsNone) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea);
  ForecastOptions options = at_five(day);
  const DailyForecast made = make_forecast(site_of({sea.data}), options);
  options.hindsight = true;
  const DailyForecast asked = make_forecast(site_of({sea.data}), options);
  EXPECT_FALSE(asked.snapshot.hindsight);
  expect_same(asked, made);
}

TEST(MakeForecast, DoesNotDependOnTheNumberOfThreads) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea);
  ColumnData mirrored = sea.data;
  for (auto& piece : mirrored.current.pieces)
    for (Horizontal& value : piece.column.value) value = std::conj(value);
  const SiteData data = site_of({sea.data, mirrored});
  ForecastOptions options = at_five();
  const DailyForecast alone = make_forecast(data, options);
  expect_same(make_forecast(data, options), alone);
  options.threads = 2;
  expect_same(make_forecast(data, options), alone);
}

TEST(MakeForecast, OneColumnThatFailsDoesNotStopTheOthers) {
  KnownSeriesForTests sea = sea_until(end_of_day);
  add_wind_and_waves(sea);
  ColumnData dry = sea.data;
  dry.current = {};
  const Snapshot snapshot = make_forecast(site_of({sea.data, dry}), at_five()).snapshot;
  EXPECT_EQ(snapshot.columns[0].current_status[0], SampleStatus::ok);
  for (const SampleStatus status : snapshot.columns[1].current_status)
    EXPECT_EQ(status, SampleStatus::missing);
  EXPECT_TRUE(snapshot.degraded);
  EXPECT_TRUE(says(snapshot, "1 of 2 columns are not calibrated")) << snapshot.headline;
}

TEST(MakeForecast, LevelsThatAreNowhereWetAreLeftOut) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model"), instants(end_of_day - days(2), end_of_day), {2, 8, 60},
              [](UtcTime, double depth) {
                return depth > 30 ? Horizontal(nan, nan) : Horizontal(0.2, 0.1);
              });
  const Snapshot snapshot = make_forecast(site_of({sea.data}), at_five()).snapshot;
  EXPECT_EQ(snapshot.depth_m, depth_m);
  EXPECT_EQ(snapshot.columns[0].current_m_s.size(), 25 * depth_m.size());
  EXPECT_EQ(snapshot.columns[0].current_status[1], SampleStatus::ok);
}

}  // namespace
}  // namespace slackwater::calibration::daily_forecast_test
