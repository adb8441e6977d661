#include "twin/risk/workability/daylight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "twin/risk/workability/sun_position.h"

namespace slackwater::twin::daylight_test {
namespace {

using Kind = DayOfLight::Kind;

const GeoPoint alpha_ventus = GeoPoint::from_degrees(54.01, 6.60);
const GeoPoint hammerfest = GeoPoint::from_degrees(70.66, 23.68);

/// Meeus, Astronomical Algorithms, example 25.a: 1992 October 13, 0 h TD: right ascension
/// 13h13m31.4s, declination -7.78507. The sun stands in the zenith of its own latitude at its own
/// Greenwich hour angle.
TEST(SunPosition, TheExampleOfMeeus) {
  constexpr double delta_t_s = 59;
  const UtcTime time = parse_utc("1992-10-13T00:00:00Z") - std::chrono::seconds(59);
  // Sidereal time of Greenwich at 0 h UT of that day by the other form (chapter 12, 12.2), seconds.
  constexpr double t = (2448908.5 - 2451545.0) / 36525;
  const double sidereal_s = std::fmod(24110.54841 + 8640184.812866 * t + 0.093104 * t * t, 86400);
  const double sidereal_deg = (sidereal_s - 1.00274 * delta_t_s) / 240;
  const double right_ascension_deg = 15 * (13 + 13.0 / 60 + 31.4 / 3600);
  const GeoPoint below = GeoPoint::from_degrees(
      -7.78507, normalised_longitude_deg(right_ascension_deg - sidereal_deg));
  EXPECT_NEAR(sun_position(below, time).elevation_deg, 90, 0.01);
}

TEST(SunPosition, NoonIsDueSouthAndAsHighAsColatitudeAndDeclination) {
  // Solstice of 2024: 20 June 20:51 UTC, declination 23.436.
  const UtcTime noon =
      light_of(alpha_ventus, parse_day("2024-06-20"), Light::sun_up, std::nullopt).noon;
  const SunPosition sun = sun_position(alpha_ventus, noon);
  EXPECT_NEAR(sun.elevation_deg, 90 - 54.01 + 23.436, 0.01);
  EXPECT_NEAR(sun.azimuth_deg, 180, 0.1);
  const SunPosition morning = sun_position(alpha_ventus, noon - std::chrono::hours(6));
  EXPECT_GT(morning.azimuth_deg, 0);
  EXPECT_LT(morning.azimuth_deg, 180);
}

TEST(SunPosition, ItSetsAtTheAntipodeByAsMuchAsItRises) {
  Rng random(3, "sun");
  for (int i = 0; i < 200; ++i) {
    const double latitude = random.uniform(-80, 80);
    const GeoPoint north = GeoPoint::from_degrees(latitude, random.uniform(-180, 180));
    const UtcTime time = parse_utc("2021-01-01T00:00:00Z") +
                         Duration(static_cast<Duration::rep>(random.uniform(0, 3e10)));
    const SunPosition here = sun_position(north, time);
    const GeoPoint antipode =
        GeoPoint::from_degrees(-latitude, normalised_longitude_deg(north.longitude_deg() + 180));
    const SunPosition there = sun_position(antipode, time);
    EXPECT_NEAR(here.elevation_deg, -there.elevation_deg, 0.006) << "twice the parallax";
  }
}

/// From cos H = (sin h0 - sin phi sin delta) / (cos phi cos delta): at the equinox nearly 12 h and
/// twice the way through 50 minutes of arc of refraction and disc, at 15 cos phi degrees an hour.
TEST(Daylight, TheDayOfTheEquinoxIsTwelveHoursAndTheHorizonsShare) {
  for (const double latitude : {-50.0, -10.0, 0.0, 30.0, 54.0}) {
    const GeoPoint place = GeoPoint::from_degrees(latitude, 3);
    const DayOfLight day = light_of(place, parse_day("2024-03-20"), Light::sun_up, std::nullopt);
    ASSERT_EQ(day.kind, Kind::comes_and_goes);
    const double length_h = hours_between(*day.begin, *day.end);
    const double expected_h = 12 + 2 * (50.0 / 60 / 15) / std::cos(latitude * constants::pi / 180);
    EXPECT_NEAR(length_h, expected_h, 0.05) << latitude;
  }
}

TEST(Daylight, TwilightLiesOutsideTheDayAndDeeperTwilightOutsideThat) {
  const UtcDay day = parse_day("2024-10-01");
  const auto sun = light_of(alpha_ventus, day, Light::sun_up, std::nullopt);
  const auto civil = light_of(alpha_ventus, day, Light::civil, std::nullopt);
  const auto nautical = light_of(alpha_ventus, day, Light::nautical, std::nullopt);
  EXPECT_LT(*nautical.begin, *civil.begin);
  EXPECT_LT(*civil.begin, *sun.begin);
  EXPECT_LT(*sun.end, *civil.end);
  EXPECT_LT(*civil.end, *nautical.end);
  EXPECT_NEAR(sun_position(alpha_ventus, *civil.end).elevation_deg, -6, 0.001);
}

TEST(Daylight, BeyondThePolarCircleThereAreDaysWithoutNightAndWithoutDay) {
  EXPECT_EQ(light_of(hammerfest, parse_day("2024-06-21"), Light::sun_up, std::nullopt).kind,
            Kind::always);
  EXPECT_EQ(light_of(hammerfest, parse_day("2024-12-21"), Light::sun_up, std::nullopt).kind,
            Kind::never);
  EXPECT_EQ(light_of(hammerfest, parse_day("2024-12-21"), Light::civil, std::nullopt).kind,
            Kind::comes_and_goes)
      << "noon twilight";
  // South of the circle, in June, twilight lasts all night.
  const GeoPoint shetland = GeoPoint::from_degrees(61.5, -1);
  EXPECT_EQ(light_of(shetland, parse_day("2024-06-21"), Light::civil, std::nullopt).kind,
            Kind::always);
  EXPECT_EQ(
      light_of(GeoPoint::from_degrees(90, 0), parse_day("2024-07-01"), Light::sun_up, std::nullopt)
          .kind,
      Kind::always);
  EXPECT_EQ(
      light_of(GeoPoint::from_degrees(-90, 0), parse_day("2024-07-01"), Light::sun_up, std::nullopt)
          .kind,
      Kind::never);
}

/// All days of a year: the polar day and night of Hammerfest have one beginning and one end, and
/// the first and last days have a night that is short.
TEST(Daylight, PolarDayAndNightAreOneStretchOfTheYearEach) {
  std::vector<Kind> kinds;
  for (int i = 0; i < 366; ++i)
    kinds.push_back(light_of(hammerfest, parse_day("2024-01-01") + std::chrono::days(i),
                             Light::sun_up, std::nullopt)
                        .kind);
  const auto changes = [&] {
    int count = 0;
    for (std::size_t i = 1; i < kinds.size(); ++i) count += kinds[i] != kinds[i - 1] ? 1 : 0;
    return count;
  };
  EXPECT_EQ(changes(), 4);
  EXPECT_NEAR(static_cast<double>(std::count(kinds.begin(), kinds.end(), Kind::always)), 77, 4)
      << "from the middle of May to the end of July";
}

TEST(Daylight, IsOfTheDayOfTheZoneAndInItsTime) {
  const TimeZone zone = TimeZone::named("Europe/Berlin");
  const DayOfLight summer = light_of(alpha_ventus, parse_day("2024-06-21"), Light::sun_up, zone);
  EXPECT_EQ(text_of(summer, zone).substr(0, 3), "05:");
  EXPECT_NE(text_of(summer, zone).find("CEST"), std::string::npos);
  EXPECT_NE(text_of(light_of(alpha_ventus, parse_day("2024-12-21"), Light::sun_up, zone), zone)
                .find("CET"),
            std::string::npos);
  // In Auckland the day of 2 January begins on the first in UTC.
  const TimeZone auckland = TimeZone::named("Pacific/Auckland");
  const DayOfLight far = light_of(GeoPoint::from_degrees(-36.8, 174.8), parse_day("2024-01-02"),
                                  Light::sun_up, auckland);
  EXPECT_EQ(format_utc(*far.begin).substr(0, 10), "2024-01-01");
  EXPECT_EQ(auckland.text(*far.begin).substr(0, 10), "2024-01-02");
}

TEST(Daylight, StepsAreLightFromBeginningToEnd) {
  const StepClock clock{parse_utc("2024-03-01T00:00:00Z"), std::chrono::minutes(10), 6 * 24 * 30};
  const StepRanges light = light_steps(clock, alpha_ventus, Light::civil);
  ASSERT_EQ(light.size(), 30U);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const DayOfLight day =
        light_of(alpha_ventus, parse_day("2024-03-01") + std::chrono::days(static_cast<int>(i)),
                 Light::civil, std::nullopt);
    const UtcTime begin = clock.time_of(light[i].begin);
    const UtcTime end = clock.time_of(light[i].end);
    EXPECT_GE(begin, *day.begin);
    EXPECT_LT(begin - *day.begin, clock.step);
    EXPECT_LE(end, *day.end);
    EXPECT_LT(*day.end - end, clock.step);
  }
  const StepClock winter{parse_utc("2024-12-15T00:00:00Z"), std::chrono::hours(1), 240};
  EXPECT_TRUE(light_steps(winter, hammerfest, Light::sun_up).empty());
}

TEST(Daylight, AnotherWordIsRefused) {
  EXPECT_EQ(parse_light("civil"), Light::civil);
  EXPECT_THROW(static_cast<void>(parse_light("dusk")), Error);
}

}  // namespace
}  // namespace slackwater::twin::daylight_test
