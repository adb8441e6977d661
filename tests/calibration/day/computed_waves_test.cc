#include "calibration/day/computed_waves.h"

#include <gtest/gtest.h>

#include "calibration/day/daily_forecast.h"
#include "fields/wave/growth.h"
#include "tests/support/known_series_for_tests.h"

namespace slackwater::calibration::computed_waves_test {
namespace {

using std::chrono::days;
using std::chrono::hours;
using namespace tests;

const UtcDay day = parse_day("2024-06-11");
const UtcTime end_of_day = UtcTime(day) + days(1);

/// Currents, and a steady wind of 13 m/s from the west.
KnownSeriesForTests windy_sea() {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model", 11), instants(end_of_day - days(2), end_of_day), {2, 8},
              steady({0.2, 0.1}));
  sea.wind(received(analysis_of("wind", 12), end_of_day),
           instants(end_of_day - days(3), end_of_day + days(4)),
           steady(vector_from_direction(13, 270)));
  return sea;
}

void add_waves(KnownSeriesForTests& sea, UtcTime from, UtcTime to) {
  sea.waves(
      received(analysis_of("waves", 13), end_of_day), instants(from, to),
      [](UtcTime) { return 1.5; }, [](UtcTime) { return 6.0; }, [](UtcTime) { return 280.0; });
}

DailyForecast forecast_of_sea(const KnownSeriesForTests& sea, std::optional<Fetch> fetch = {},
                              WindPolicy wind = WindPolicy::best) {
  SiteData data = site_of({sea.data});
  data.site.fetch = std::move(fetch);
  ForecastOptions options;
  options.issued = end_of_day + hours(5);
  options.horizon = hours(72);
  options.wind = wind;
  return make_forecast(data, options);
}

bool says(const DailyForecast& made, const std::string& words) {
  return made.snapshot.headline.find(words) != std::string::npos;
}

TEST(ComputedWaves, AreNoneWhereAProductGivesThemAll) {
  KnownSeriesForTests sea = windy_sea();
  add_waves(sea, end_of_day - days(1), end_of_day + days(3));
  const DailyForecast made = forecast_of_sea(sea);
  EXPECT_FALSE(made.computed_waves);
  EXPECT_FALSE(made.snapshot.degraded) << made.snapshot.headline;
}

TEST(ComputedWaves, WithoutAProductDegradeTheForecastAndStateTheFetchAndWhatItDoes) {
  const DailyForecast made = forecast_of_sea(windy_sea());
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_TRUE(says(made, "o wave product is stored: the waves are computed from the wind alone"))
      << made.snapshot.headline;
  EXPECT_TRUE(says(made, "a fetch of 200 km is assumed")) << made.snapshot.headline;
  ASSERT_TRUE(made.computed_waves);
  const ComputedWaves& waves = *made.computed_waves;
  EXPECT_EQ(waves.hours, 73u);
  EXPECT_TRUE(waves.is_fetch_assumed);
  EXPECT_NEAR(waves.highest_m, fetch_limited_sea(13, 200e3, 30).significant_height_m, 0.02);
  EXPECT_NEAR(waves.highest_half_fetch_m.value(),
              fetch_limited_sea(13, 100e3, 30).significant_height_m, 0.02);
  EXPECT_NEAR(waves.highest_twice_fetch_m.value(),
              fetch_limited_sea(13, 400e3, 30).significant_height_m, 0.02);
}

TEST(ComputedWaves, OverAFetchThatTheSiteGivesNothingIsAssumed) {
  const DailyForecast sea = forecast_of_sea(windy_sea(), Fetch({{180, 360, 300e3}, {0, 180, 4e3}}));
  EXPECT_TRUE(sea.snapshot.degraded) << "still no product's waves";
  EXPECT_TRUE(says(sea, "fetch 4 to 300 km by the direction of the wind"));
  EXPECT_FALSE(says(sea, "assumed"));
  EXPECT_FALSE(sea.computed_waves->highest_half_fetch_m);
  const DailyForecast land =
      forecast_of_sea(windy_sea(), Fetch({{0, 180, 300e3}, {180, 360, 4e3}}));
  EXPECT_GT(sea.computed_waves->highest_m, 3 * land.computed_waves->highest_m)
      << "the same wind from the sea and from the land";
}

TEST(ComputedWaves, AfterAProductThatEndsEarlyAreNamedWithTheirHours) {
  KnownSeriesForTests sea = windy_sea();
  add_waves(sea, end_of_day - days(1), end_of_day + hours(40));
  const DailyForecast made = forecast_of_sea(sea);
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_TRUE(says(made, "he waves of 32 of 73 hours are computed from the wind"))
      << made.snapshot.headline;
  EXPECT_FALSE(made.computed_waves->of_wind_alone);
}

TEST(ComputedWaves, TheLastHoursAfterASixHourlyProductAreNoTrouble) {
  KnownSeriesForTests sea = windy_sea();
  add_waves(sea, end_of_day - days(1), end_of_day + days(3) - hours(6));
  const DailyForecast made = forecast_of_sea(sea);
  EXPECT_FALSE(made.snapshot.degraded) << made.snapshot.headline;
  EXPECT_EQ(made.computed_waves->hours, 6u) << "but they are told where one looks";
}

TEST(ComputedWaves, PersistenceThatWasAskedForIsNoTroubleUnlessNoSeaIsKnown) {
  KnownSeriesForTests sea = windy_sea();
  add_waves(sea, end_of_day - days(1), end_of_day);
  EXPECT_FALSE(forecast_of_sea(sea, {}, WindPolicy::persist).snapshot.degraded);
  const DailyForecast made = forecast_of_sea(windy_sea(), {}, WindPolicy::persist);
  EXPECT_TRUE(made.snapshot.degraded);
  EXPECT_TRUE(says(made, "from the wind alone")) << made.snapshot.headline;
}

TEST(ComputedWaves, WithoutWindTheLastKnownSeaIsSaidToBeKept) {
  KnownSeriesForTests sea;
  sea.current(analysis_of("model", 11), instants(end_of_day - days(2), end_of_day), {2, 8},
              steady({0.2, 0.1}));
  add_waves(sea, end_of_day - days(1), end_of_day);
  const DailyForecast made = forecast_of_sea(sea);
  EXPECT_TRUE(says(made, "he waves of 72 of 73 hours are the last ones known"))
      << made.snapshot.headline;
  EXPECT_FALSE(says(made, "fetch"));
}

}  // namespace
}  // namespace slackwater::calibration::computed_waves_test
