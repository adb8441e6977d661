// Who is about a site: places and approaches against a plane laid by hand, and the rule of age.
#include "api/ask/traffic/traffic_about.h"

#include <gtest/gtest.h>

#include <cmath>

#include "api/program/paths.h"
#include "fields/base/numbers/random.h"
#include "fields/geo/local_frame.h"

namespace slackwater::tests::traffic_about_test {
namespace {

using namespace api;

using std::chrono::minutes;
using std::chrono::seconds;

const UtcTime at = parse_utc("2025-03-04T06:00:00Z");
const GeoPoint site = GeoPoint::from_degrees(54, 6.5);
constexpr double knot_m_s = 1852.0 / 3600.0;

/// A place so many metres east and north of the site.
GeoPoint place_at(double east_m, double north_m) {
  const double down_m = (east_m * east_m + north_m * north_m) / (2 * 6'371'008.8);
  return LocalFrame(site).to_geodetic({east_m, north_m, -down_m}).point;
}

TrafficRule rule() { return read_traffic_rule(data_folder() / "traffic" / "rule.yaml"); }

struct Ship {
  double east_m = 0, north_m = 0;
  double speed_m_s = 5, course_deg = 0;
  Duration age{};
  ingest::AisClass speaker = ingest::AisClass::a;
};
LastHeard heard_of(const Ship& ship, std::uint32_t mmsi = 211000001) {
  LastHeard heard;
  heard.mmsi = mmsi;
  heard.speaker = ship.speaker;
  heard.position = {at - ship.age, place_at(ship.east_m, ship.north_m), ship.speed_m_s,
                    Angle::from_degrees(ship.course_deg), std::nullopt};
  return heard;
}

TrafficAnswer about(const std::vector<LastHeard>& vessels,
                    const std::vector<std::pair<double, double>>& turbines = {}) {
  TrafficQuestion question{"farm", site, {}, at, rule()};
  for (const auto& [east_m, north_m] : turbines) {
    TurbinePlace turbine;
    turbine.id = "T" + std::to_string(question.turbines.size() + 1);
    turbine.point = place_at(east_m, north_m);
    question.turbines.push_back(turbine);
  }
  return traffic_about(question, {vessels, at, at, {{"a.log", ""}}});
}
VesselThere only(const TrafficAnswer& answer) {
  EXPECT_EQ(answer.vessels.size(), 1U);
  return answer.vessels.empty() ? VesselThere{} : answer.vessels.front();
}

/// Courses count from the vessel's north, which 7 km off turns by 0.09 degrees at 54 N: 11 m.
constexpr double plane_m = 11;

TEST(TrafficAbout, AShipThatComesStraightIsThereAfterTheWayThroughItsSpeed) {
  const VesselThere ship = only(about({heard_of({0, -3000, 5, 0})}));
  ASSERT_TRUE(ship.to_site);
  EXPECT_EQ(ship.to_site->passing, Passing::closing);
  EXPECT_NEAR(ship.to_site->distance_m, 0, 0.01);
  EXPECT_NEAR(ship.to_site->time_s, 600, 0.01);
  EXPECT_EQ(ship.alarm, TrafficAlarm::closing);
  EXPECT_NEAR(ship.distance_m, 3000, 0.01);
  EXPECT_NEAR(ship.bearing_deg, 180, 1e-4);
  ASSERT_TRUE(ship.ahead);
  EXPECT_NEAR(distance_m(*ship.ahead, place_at(0, -3000 + 360 * 5)), 0, 0.01) << "6 min of way";
}

TEST(TrafficAbout, AnotherCourseByADegreeMissesByItsSine) {
  const VesselThere ship = only(about({heard_of({0, -4000, 5, 10})}));
  EXPECT_NEAR(ship.to_site->distance_m, 4000 * std::sin(10 * M_PI / 180), 0.05);
  EXPECT_NEAR(ship.to_site->time_s, 4000 * std::cos(10 * M_PI / 180) / 5, 0.05);
}

TEST(TrafficAbout, WhatIsOverIsPastAndNeverMarked) {
  const VesselThere ship = only(about({heard_of({100, 400, 5, 0})}));
  EXPECT_EQ(ship.to_site->passing, Passing::past);
  EXPECT_NEAR(ship.to_site->distance_m, 100, 0.01);
  EXPECT_NEAR(ship.to_site->time_s, -80, 0.01);
  EXPECT_EQ(ship.alarm, TrafficAlarm::none) << "412 m off, and going away";
}

TEST(TrafficAbout, WhoLiesStillIsMarkedOnlyWithinTheDistance) {
  for (const double north_m : {450.0, 550.0}) {
    const VesselThere ship = only(about({heard_of({0, north_m, 0.1, 77})}));
    EXPECT_EQ(ship.to_site->passing, Passing::still) << "0.1 m/s is the noise of a fix";
    EXPECT_NEAR(ship.to_site->distance_m, north_m, 0.01);
    EXPECT_EQ(ship.to_site->time_s, 0);
    EXPECT_EQ(ship.alarm, north_m < 500 ? TrafficAlarm::inside : TrafficAlarm::none);
    EXPECT_FALSE(ship.ahead || ship.is_carried_on);
  }
}

TEST(TrafficAbout, TheLimitsAreHeldOnBothSides) {
  const double far_m = 5.0 * 30 * 60;  // in 30 min
  EXPECT_EQ(only(about({heard_of({499, -far_m + 10, 5, 0})})).alarm, TrafficAlarm::closing);
  EXPECT_EQ(only(about({heard_of({520, -far_m + 10, 5, 0})})).alarm, TrafficAlarm::none) << "wide";
  EXPECT_EQ(only(about({heard_of({499, -far_m - 60, 5, 0})})).alarm, TrafficAlarm::none) << "late";
}

TEST(TrafficAbout, TheTurbineThatMattersIsTheOneItComesNearestTo) {
  const VesselThere ship = only(
      about({heard_of({0, -3000, 5, 0})}, {{-900, -2000}, {700, 0}, {-800, 2000}, {0, -3400}}));
  ASSERT_TRUE(ship.to_turbine);
  EXPECT_EQ(ship.to_turbine->to, "T2") << "T4 is nearer, and behind";
  EXPECT_NEAR(ship.to_turbine->distance_m, 700, 0.5);
  const VesselThere late =
      only(about({heard_of({0, -3000, 5, 0})}, {{300, 2000}, {400, 0}, {0, 9000}}));
  EXPECT_NEAR(late.told->time_s, 600, 0.5) << "of all within the limits the first";
  EXPECT_EQ(late.to_turbine->to, "T2") << "not T1, which it passes nearer and later";
}

TEST(TrafficAbout, AFreshReportIsCarriedOnAndAnOldOneStays) {
  const VesselThere fresh = only(about({heard_of({0, -3000, 5, 90, seconds(100)})}));
  EXPECT_TRUE(fresh.is_fresh && fresh.is_carried_on);
  EXPECT_NEAR(distance_m(fresh.place, place_at(500, -3000)), 0, 0.1);
  EXPECT_EQ(fresh.age, seconds(100));
  const VesselThere old = only(about({heard_of({0, -3000, 5, 0, seconds(181)})}));
  EXPECT_FALSE(old.is_fresh || old.is_carried_on);
  EXPECT_NEAR(distance_m(old.place, place_at(0, -3000)), 0, 1e-3);
  EXPECT_FALSE(old.to_site || old.to_turbine || old.ahead || old.told);
  EXPECT_EQ(old.alarm, TrafficAlarm::none);
}

TEST(TrafficAbout, HowLongAReportIsFreshIsByClassAndSpeed) {
  using ingest::AisClass;
  struct Case {
    AisClass speaker;
    double speed_kn;
    int fresh_s;
  };
  for (const Case& each : {Case{AisClass::a, 3.1, 180}, Case{AisClass::a, 2.9, 1080},
                           Case{AisClass::b, 2.9, 180}, Case{AisClass::b, 1.9, 1080}}) {
    Ship ship{0, -9000, each.speed_kn * knot_m_s, 0, seconds(each.fresh_s), each.speaker};
    EXPECT_TRUE(only(about({heard_of(ship)})).is_fresh) << each.speed_kn;
    ship.age += seconds(1);
    EXPECT_FALSE(only(about({heard_of(ship)})).is_fresh) << each.speed_kn;
  }
  LastHeard mute = heard_of({0, -3000, 0, 0, seconds(181)});
  mute.position.speed_over_ground_m_s.reset();
  EXPECT_FALSE(only(about({mute})).is_fresh) << "who does not say its speed may be under way";
}

TEST(TrafficAbout, WhoDoesNotSayHowItMovesHasAPlaceAndNoApproach) {
  for (const bool has_speed : {false, true}) {
    LastHeard mute = heard_of({0, -300, 5, 0, seconds(60)});
    mute.position.course_over_ground.reset();
    if (!has_speed) mute.position.speed_over_ground_m_s.reset();
    const VesselThere ship = only(about({mute}));
    EXPECT_TRUE(ship.is_fresh);
    EXPECT_FALSE(ship.is_carried_on || ship.to_site || ship.ahead);
  }
}

TEST(TrafficAbout, WhatIsFarOrSilentForLongIsLeftOutAndCounted) {
  const TrafficAnswer answer =
      about({heard_of({0, 51'000, 5, 180}), heard_of({0, 3000, 5, 0, minutes(61)}, 2),
             heard_of({0, 4000, 5, 0, minutes(59)}, 3)});
  ASSERT_EQ(answer.vessels.size(), 1U);
  EXPECT_EQ(answer.vessels[0].heard.mmsi, 3U);
  EXPECT_EQ(answer.too_old, 1U);
}

TEST(TrafficAbout, MarkedOnesComeFirstThenTheNearest) {
  const TrafficAnswer answer = about(
      {heard_of({2000, 0, 5, 90}, 1), heard_of({1000, 0, 5, 0}, 2), heard_of({0, -5000, 5, 0}, 3)});
  ASSERT_EQ(answer.vessels.size(), 3U);
  EXPECT_EQ(answer.vessels[0].heard.mmsi, 3U);
  EXPECT_EQ(answer.vessels[1].heard.mmsi, 2U);
  std::vector<LastHeard> many;
  for (std::uint32_t i = 1; i <= 600; ++i) many.push_back(heard_of({5.0 * i, 2000, 5, 0}, i));
  EXPECT_EQ(about(many).left_out, 100U);
}

/// Against the geodesic, stepped: no plane.
TEST(TrafficAbout, NoTimeOnTheWayIsNearerThanTheApproach) {
  Rng rng(8, "tests/traffic_about");
  int closing = 0;
  for (int round = 0; round < 40; ++round) {
    const Ship ship{rng.uniform(-5000, 5000), rng.uniform(-5000, 5000), rng.uniform(1, 12),
                    rng.uniform(0, 360)};
    const VesselThere there = only(about({heard_of(ship)}));
    const double course = ship.course_deg * M_PI / 180;
    const double at_s = there.to_site->time_s;
    const auto away_m = [&](double t_s) {
      return distance_m(site, place_at(ship.east_m + t_s * ship.speed_m_s * std::sin(course),
                                       ship.north_m + t_s * ship.speed_m_s * std::cos(course)));
    };
    EXPECT_NEAR(away_m(at_s), there.to_site->distance_m, plane_m) << round;
    for (const double step_s : {-300.0, -60.0, 60.0, 300.0})
      EXPECT_GT(away_m(at_s + step_s), there.to_site->distance_m - plane_m) << round;
    EXPECT_EQ(there.to_site->passing == Passing::closing, at_s > 0) << round;
    closing += at_s > 0 ? 1 : 0;
  }
  EXPECT_GT(closing, 8);
}

TEST(TrafficAbout, CoursesAreFromTheVesselsOwnNorthAndTheAntimeridianIsNoBorder) {
  const GeoPoint east = GeoPoint::from_degrees(54, 179.99);
  TrafficQuestion question{"farm", GeoPoint::from_degrees(54, -179.99), {}, at, rule()};
  LastHeard heard = heard_of({});
  heard.position.point = east;
  heard.position.course_over_ground = Angle::from_degrees(90);
  const TrafficAnswer answer = traffic_about(question, {{heard}, at, at, {{"a.log", ""}}});
  const VesselThere ship = only(answer);
  EXPECT_NEAR(ship.distance_m, distance_m(east, question.place), 0.01);
  EXPECT_NEAR(ship.bearing_deg, 270, 0.02);
  EXPECT_EQ(ship.alarm, TrafficAlarm::closing);
}

}  // namespace
}  // namespace slackwater::tests::traffic_about_test
