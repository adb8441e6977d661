#include "api/ask/run/ais_traffic.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "ingest/ais/read_ais.h"
#include "tests/support/shared_data.h"
#include "twin/traffic/deviation.h"
#include "twin/traffic/pursuit.h"

namespace slackwater::tests::ais_traffic_test {
namespace {

using namespace api;
using ingest::AisPosition;
using ingest::AisTrack;

const UtcTime epoch = parse_utc("2022-01-03T00:00:00Z");

AisTrack track_of(std::vector<AisPosition> positions) {
  AisTrack track;
  track.mmsi = 338125067;
  track.positions = std::move(positions);
  return track;
}

AisPosition position_of(double time_s, const GeoPoint& point, std::optional<double> speed_m_s = {},
                        std::optional<double> course_deg = {}) {
  AisPosition position;
  position.time = epoch + Duration(static_cast<Duration::rep>(time_s * 1000));
  position.point = point;
  position.speed_over_ground_m_s = speed_m_s;
  if (course_deg) position.course_over_ground = Angle::from_degrees(*course_deg);
  position.heading = position.course_over_ground;
  return position;
}

TEST(AisOnSite, NorthIsNorthAndEastIsEastInMetresAndSeconds) {
  const GeoPoint origin = GeoPoint::from_degrees(55, 8);
  const LocalFrame site(origin);
  const GeoPoint north = GeoPoint::from_degrees(55.01, 8);
  const GeoPoint east = GeoPoint::from_degrees(55, 8.01);
  const twin::Track track = track_on_site(
      track_of({position_of(-1.5, north, 3.0, 0.0), position_of(60, east, 4.0, 90.0)}), site,
      epoch);
  ASSERT_EQ(track.points().size(), 2U);
  const twin::TrackPoint& first = track.points()[0];
  EXPECT_DOUBLE_EQ(first.t_s, -1.5);
  EXPECT_NEAR(first.position_m.x, distance_m(origin, north), 1e-3);  // a chord of a kilometre
  EXPECT_NEAR(first.position_m.y, 0, 1e-3);
  EXPECT_EQ(first.position_m.z, 0);
  EXPECT_NEAR(first.velocity_m_s->x, 3, 1e-6);
  EXPECT_NEAR(first.velocity_m_s->y, 0, 1e-6);
  EXPECT_NEAR(*first.heading_rad, 0, 1e-6);
  const twin::TrackPoint& second = track.points()[1];
  EXPECT_NEAR(second.position_m.y, distance_m(origin, east), 1e-3);
  EXPECT_NEAR(second.velocity_m_s->y, 4, 1e-6);
  EXPECT_NEAR(*second.heading_rad, constants::pi / 2,
              2e-4);  // 640 m to the east meridians turn by 1.4e-4
}

TEST(AisOnSite, FarAwayTheVelocityIsThatOfThePositions) {
  // Due north at 10 m/s, 80 km east of the site: in its plane that is not along its own north any
  // more.
  const LocalFrame site(GeoPoint::from_degrees(55, 8));
  constexpr double metres_of_degree = 111'337.0;  // of the meridian at 55 N, WGS 84
  const GeoPoint start = GeoPoint::from_degrees(55, 9.25);
  const GeoPoint end = GeoPoint::from_degrees(55 + 100 / metres_of_degree, 9.25);
  const twin::Track track = track_on_site(
      track_of({position_of(0, start, 10.0, 0.0), position_of(10, end, 10.0, 0.0)}), site, epoch);
  const twin::Triple<double> made =
      0.1 * (track.points()[1].position_m - track.points()[0].position_m);
  const twin::Triple<double>& told = *track.points()[0].velocity_m_s;
  EXPECT_NEAR(told.x, made.x, 5e-3);
  EXPECT_NEAR(told.y, made.y, 5e-3);
  EXPECT_GT(std::abs(made.y), 0.15) << "a degree of convergence";
}

TEST(AisOnSite, SpeedWithoutCourseIsNoVelocityButStandingStillIs) {
  const LocalFrame site(GeoPoint::from_degrees(55, 8));
  const GeoPoint place = GeoPoint::from_degrees(55, 8);
  const twin::Track track = track_on_site(
      track_of({position_of(0, place), position_of(1, place, 2.0), position_of(2, place, 0.0)}),
      site, epoch);
  EXPECT_FALSE(track.points()[0].velocity_m_s);
  EXPECT_FALSE(track.points()[1].velocity_m_s);
  ASSERT_TRUE(track.points()[2].velocity_m_s);
  EXPECT_EQ(track.points()[2].velocity_m_s->x, 0);
  EXPECT_FALSE(track.points()[2].heading_rad);
}

TEST(AisOnSite, TrafficIsWhatIsNearAndAfloat) {
  const GeoPoint origin = GeoPoint::from_degrees(55, 8);
  const LocalFrame site(origin);
  AisTrack near =
      track_of({position_of(0, origin), position_of(60, GeoPoint::from_degrees(57, 8))});
  near.identity.name = "RUM LASS";
  near.identity.length_m = 13;
  AisTrack far = track_of({position_of(0, GeoPoint::from_degrees(57, 8))});
  AisTrack base = track_of({position_of(0, origin)});
  base.speaker = ingest::AisClass::base_station;
  const std::vector<AisTrack> tracks{near, far, base, track_of({})};
  const auto traffic = traffic_on_site(tracks, site, epoch, 20'000);
  ASSERT_EQ(traffic.size(), 1U);
  EXPECT_EQ(traffic[0].id, 338125067U);
  EXPECT_EQ(traffic[0].name, "RUM LASS");
  EXPECT_EQ(traffic[0].length_m, 13);
  EXPECT_EQ(traffic[0].track.points().size(), 1U);
}

/// A small boat: it turns and gathers way within limits, and the current carries it.
struct Boat {
  twin::Triple<double> position_m;
  double yaw_rad = 0;
  double speed_m_s = 0;

  void step(const twin::Heading& wanted, const twin::Triple<double>& current_m_s, double dt_s) {
    constexpr double most_turn_rad_s = 0.35;
    constexpr double most_acceleration_m_s2 = 0.5;
    const double turn = std::remainder(wanted.yaw_rad - yaw_rad, 2 * constants::pi);
    yaw_rad += std::clamp(turn, -most_turn_rad_s * dt_s, most_turn_rad_s * dt_s);
    speed_m_s += std::clamp(wanted.speed_m_s - speed_m_s, -most_acceleration_m_s2 * dt_s,
                            most_acceleration_m_s2 * dt_s);
    const twin::Triple<double> through{speed_m_s * std::cos(yaw_rad), speed_m_s * std::sin(yaw_rad),
                                       0};
    position_m = position_m + dt_s * (through + current_m_s);
  }
};

twin::Deviation deviation_of_boat(const twin::Track& track, const twin::Pursuit& pursuit,
                                  const twin::Triple<double>& current_m_s,
                                  const twin::Triple<double>& known_current_m_s) {
  constexpr double dt_s = 0.1;
  const double start_s = track.points().front().t_s;
  const double end_s = track.points().back().t_s;
  const twin::TrackState first = track.at(start_s);
  Boat boat{first.position_m, std::atan2(first.velocity_m_s.y, first.velocity_m_s.x),
            std::hypot(first.velocity_m_s.x, first.velocity_m_s.y)};
  std::vector<twin::FollowedPoint> followed;
  for (int step = 0; start_s + step * dt_s <= end_s; ++step) {
    const double t_s = start_s + step * dt_s;
    followed.push_back({t_s, boat.position_m});
    const twin::TrackState wanted = track.at(t_s);
    if (!wanted.is_known()) continue;
    boat.step(twin::pursue(pursuit, wanted, boat.position_m, known_current_m_s, boat.yaw_rad),
              current_m_s, dt_s);
  }
  return twin::deviation_from(track, {}, followed);
}

TEST(AisReferencedTrajectory, ASmallBoatFollowsRealSmallCraftAndTheDeviationIsReported) {
  SLACKWATER_NEEDS_SHARED(shared);
  const ingest::AisTracks read =
      ingest::read_ais_tracks(shared / "data/ais/classB_moving_20220103.csv");
  // CAPTAIN D: 19 fixes in 21 minutes, 5.3 km at 4.2 m/s.
  const auto captain = std::find_if(read.tracks.begin(), read.tracks.end(),
                                    [](const AisTrack& track) { return track.mmsi == 367479170; });
  ASSERT_NE(captain, read.tracks.end());
  const LocalFrame site(captain->positions.front().point);
  const twin::Track track = track_on_site(*captain, site, captain->positions.front().time);
  const twin::Triple<double> current{0.3, -0.4, 0};
  const twin::Deviation aware = deviation_of_boat(track, {0.1, 10, 0.05}, current, current);
  EXPECT_EQ(aware.unknown, 0U);
  EXPECT_GT(aware.samples, 12'000U);
  // The boat turns faster than the track: only its limits are in the way.
  EXPECT_LT(aware.across.rms_m, 0.1);
  EXPECT_LT(aware.along.rms_m, 0.1);
  // A current of 0.5 m/s nobody told it about pushes it U/k = 5 m from its place, no further.
  const twin::Deviation unaware = deviation_of_boat(track, {0.1, 10, 0.05}, current, {});
  EXPECT_NEAR(std::hypot(unaware.across.mean_m, unaware.along.mean_m), 5, 1.5);
  // A boat of 3.5 m/s cannot keep the time of one that does 4.2 on average.
  const twin::Deviation slow = deviation_of_boat(track, {0.1, 3.5, 0.05}, {}, {});
  EXPECT_LT(slow.along.mean_m, -100);
  RecordProperty("across_rms_m", std::to_string(aware.across.rms_m));
  RecordProperty("along_rms_m", std::to_string(aware.along.rms_m));
  RecordProperty("slow_along_mean_m", std::to_string(slow.along.mean_m));
}

TEST(AisReferencedTrajectory, ReportsThatAreLeftOutLieNearerToTheSmoothCurveThanToStraightLegs) {
  SLACKWATER_NEEDS_SHARED(shared);
  // Leaves every second report out and asks the track for it: the error is what interpolation over
  // about two minutes costs.
  const ingest::AisTracks read =
      ingest::read_ais_tracks(shared / "data/ais/classB_moving_20220103.csv");
  double smooth_squares = 0, straight_squares = 0;
  std::size_t count = 0;
  for (const AisTrack& track : read.tracks) {
    const LocalFrame site(track.positions.front().point);
    const twin::Track whole = track_on_site(track, site, epoch);
    std::vector<twin::TrackPoint> half;
    for (std::size_t i = 0; i < whole.points().size(); i += 2) half.push_back(whole.points()[i]);
    const twin::Track thinned(half);
    for (std::size_t i = 1; i + 1 < whole.points().size(); i += 2) {
      const twin::TrackPoint& left_out = whole.points()[i];
      const twin::TrackState smooth = thinned.at(left_out.t_s, {twin::TrackCurve::smooth, 360});
      const twin::TrackState straight = thinned.at(left_out.t_s, {twin::TrackCurve::straight, 360});
      if (!smooth.is_known()) continue;
      const auto squared = [&](const twin::TrackState& state) {
        const twin::Triple<double> d = state.position_m - left_out.position_m;
        return d.x * d.x + d.y * d.y;
      };
      smooth_squares += squared(smooth);
      straight_squares += squared(straight);
      ++count;
    }
  }
  const double smooth_m = std::sqrt(smooth_squares / static_cast<double>(count));
  const double straight_m = std::sqrt(straight_squares / static_cast<double>(count));
  RecordProperty("smooth_rms_m", std::to_string(smooth_m));      // 81.8 m over about two minutes
  RecordProperty("straight_rms_m", std::to_string(straight_m));  // 98.3 m
  EXPECT_GT(count, 600U);
  EXPECT_LT(smooth_m, straight_m);
}

TEST(AisReferencedTrajectory, RealTrafficRaisesTheAlarmsThatTryingAllMomentsFinds) {
  SLACKWATER_NEEDS_SHARED(shared);
  // Miami's small craft seen from a vessel at rest in Government Cut; each contact is moved on
  // second by second.
  const ingest::AisTracks read =
      ingest::read_ais_tracks(shared / "data/ais/classB_moving_20220103.csv");
  const LocalFrame site(GeoPoint::from_degrees(25.77, -80.17));
  const auto traffic = traffic_on_site(read.tracks, site, epoch, 30'000);
  ASSERT_GT(traffic.size(), 5U);
  const twin::MovingPoint own{{0, 0, 0}, {0, 0, 0}};
  const twin::AlarmLimits limits{926, 720, 1};  // half a nautical mile, twelve minutes
  twin::TrafficPicture picture;
  std::size_t most = 0, all = 0;
  for (double t_s = 0; t_s < 1440; t_s += 60) {
    twin::populate(traffic, t_s, {}, picture);
    std::vector<std::uint32_t> expected;
    for (const twin::Contact& contact : picture.contacts) {
      const twin::MovingPoint& motion = contact.motion;
      double least_m = HUGE_VAL;
      double when_s = 0;
      for (double ahead_s = 0; ahead_s < 7200; ahead_s += 1) {
        const twin::Triple<double> p = motion.position_m + ahead_s * motion.velocity_m_s;
        if (std::hypot(p.x, p.y) >= least_m) break;  // the distance has one least value
        least_m = std::hypot(p.x, p.y);
        when_s = ahead_s;
      }
      const bool is_near = std::hypot(motion.position_m.x, motion.position_m.y) < limits.distance_m;
      if (is_near || (least_m < limits.distance_m && when_s < limits.time_s))
        expected.push_back(contact.id);
    }
    std::vector<std::uint32_t> found;
    for (const twin::Alarm& alarm : twin::alarms(own, picture.contacts, limits))
      found.push_back(alarm.id);
    EXPECT_EQ(found, expected) << t_s;
    most = std::max(most, found.size());
    all = std::max(all, picture.contacts.size());
  }
  EXPECT_GT(most, 0U);
  EXPECT_LT(most, all);
}

}  // namespace
}  // namespace slackwater::tests::ais_traffic_test
