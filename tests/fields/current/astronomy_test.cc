#include "fields/current/astronomy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

#include "fields/base/constants.h"
#include "fields/base/error.h"

namespace slackwater::astronomy_test {
namespace {

const UtcTime start = parse_utc("2023-03-05T00:00:00Z");

double speed(std::string_view name) { return tidal_constituent(name).speed_rad_s; }

TEST(TidalConstituent, SpeedsEqualTheStandardTable) {
  // Schureman (1958), table 2; the rates of the four angles reproduce it to 1e-7 degree per hour.
  const std::map<std::string, double> table{
      {"M2", 28.9841042}, {"S2", 30.0000000},  {"N2", 28.4397295},  {"K2", 30.0821373},
      {"K1", 15.0410686}, {"O1", 13.9430356},  {"P1", 14.9589314},  {"Q1", 13.3986609},
      {"M4", 57.9682085}, {"MS4", 58.9841043}, {"MN4", 57.4238338}, {"M6", 86.9523127},
      {"MSf", 1.0158958}};
  ASSERT_EQ(tidal_constituents().size(), table.size());
  for (const auto& [name, deg_per_h] : table)
    EXPECT_NEAR(speed(name) * 3600.0 * 180.0 / constants::pi, deg_per_h, 1.01e-7) << name;
}

TEST(TidalConstituent, AnUnknownNameListsTheKnownOnes) {
  try {
    (void)tidal_constituent("M3");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::not_found);
    EXPECT_NE(error.message().find("'M3'"), std::string::npos);
    EXPECT_NE(error.message().find("MN4"), std::string::npos);
  }
}

TEST(AstronomicalArgument, MeanLongitudesOfTheYear2000AreThoseOfMeeus) {
  // Meeus, Astronomical Algorithms (1998), ch. 25 and 47, at 2000-01-01 12:00; the linear formulae
  // leave out quadratic terms of 0.001 (s), 0.0003 (h) and 0.01 (p) degree a century.
  const MeanLongitudes at = mean_longitudes(parse_utc("2000-01-01T12:00:00Z"));
  const auto deg = [](double rad) { return std::remainder(rad * 180.0 / constants::pi, 360.0); };
  EXPECT_NEAR(deg(at.s_rad), std::remainder(218.3165, 360.0), 0.005);
  EXPECT_NEAR(deg(at.h_rad), std::remainder(280.4665, 360.0), 0.005);
  EXPECT_NEAR(deg(at.p_rad), std::remainder(83.3532, 360.0), 0.02);
}

TEST(AstronomicalArgument, RunsAtTheSpeedOfTheConstituent) {
  const UtcTime later = start + std::chrono::hours(1000);
  for (const Constituent& constituent : tidal_constituents()) {
    const double advance = astronomical_argument_rad(constituent, later) -
                           astronomical_argument_rad(constituent, start) -
                           constituent.speed_rad_s * 3.6e6;
    EXPECT_NEAR(std::remainder(advance, 2 * constants::pi), 0.0, 2e-5) << constituent.name;
  }
}

TEST(AstronomicalArgument, TheSolarTideFollowsTheClock) {
  EXPECT_NEAR(astronomical_argument_rad(tidal_constituent("S2"), parse_utc("2021-07-09T06:00:00Z")),
              constants::pi, 1e-9);
}

}  // namespace
}  // namespace slackwater::astronomy_test
