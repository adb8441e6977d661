#include "twin/traffic/deviation.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "twin/traffic/pursuit.h"

namespace slackwater::tests::deviation_test {
namespace {

using namespace twin;

/// From the origin to the north-east for 600 s at 5 m/s (3 north, 4 east).
Track diagonal() {
  return Track(
      {{0, {0, 0, 0}, {}, {}}, {300, {900, 1200, 0}, {}, {}}, {600, {1800, 2400, 0}, {}, {}}});
}

template <typename Position>
std::vector<FollowedPoint> followed(double from_s, double to_s, double step_s, Position position) {
  std::vector<FollowedPoint> points;
  for (double t = from_s; t <= to_s; t += step_s) points.push_back({t, position(t)});
  return points;
}

TEST(Deviation, AParallelWayIsAcrossAndALateOneAlong) {
  // Right of north-east is south-east: (-0.8, 0.6) in north and east.
  const auto beside = followed(0, 600, 1, [](double t) {
    return Triple<double>{3 * t - 8, 4 * t + 6, 50};
  });
  const Deviation right = deviation_from(diagonal(), {}, beside);
  EXPECT_EQ(right.samples, 601U);
  for (const double value : {right.across.mean_m, right.across.rms_m, right.across.most_m})
    EXPECT_NEAR(value, 10, 1e-9);
  for (const double value : {right.along.mean_m, right.along.rms_m, right.along.most_m})
    EXPECT_NEAR(value, 0, 1e-9);
  const auto behind = followed(0, 600, 1, [](double t) {
    return Triple<double>{3 * (t - 20), 4 * (t - 20), 0};
  });
  const Deviation late = deviation_from(diagonal(), {}, behind);
  EXPECT_NEAR(late.along.mean_m, -100, 1e-9);
  EXPECT_NEAR(late.along.most_m, 100, 1e-9);
  EXPECT_NEAR(late.across.most_m, 0, 1e-9) << "also before the start and short of the end";
  const auto ahead = followed(0, 600, 1, [](double t) {
    return Triple<double>{3 * (t + 20), 4 * (t + 20), 0};
  });
  EXPECT_NEAR(deviation_from(diagonal(), {}, ahead).along.mean_m, 100, 1e-9);
}

TEST(Deviation, StatisticsAreThoseOfAKnownSeries) {
  // Swings 12 m to both sides, whole periods: mean 0, root mean square 12/sqrt(2).
  const auto swinging = followed(0.0, 599.5, 0.5, [](double t) {
    const double side = 12 * std::sin(2 * constants::pi * t / 60);
    return Triple<double>{3 * t - 0.8 * side, 4 * t + 0.6 * side, 0};
  });
  const Deviation deviation = deviation_from(diagonal(), {}, swinging);
  EXPECT_NEAR(deviation.across.mean_m, 0, 1e-9);
  EXPECT_NEAR(deviation.across.rms_m, 12 / std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(deviation.across.most_m, 12, 1e-9);
}

TEST(Deviation, BeingLateRoundACornerIsNotBeingBesideTheWay) {
  const Track corner(
      {{0, {0, 0, 0}, {}, {}}, {100, {500, 0, 0}, {}, {}}, {200, {500, 500, 0}, {}, {}}});
  const auto way = [&](double t) { return corner.at(std::clamp(t, 0.0, 200.0)).position_m; };
  const Deviation late =
      deviation_from(corner, {}, followed(30, 200, 1, [&](double t) { return way(t - 30); }));
  EXPECT_NEAR(late.across.most_m, 0, 1e-9);
  EXPECT_NEAR(late.along.mean_m, -150, 1e-9);
}

TEST(Deviation, WhereTheWayCrossesItselfTheBranchOfTheTimeCounts) {
  // A loop that comes back over its own beginning 2000 m later.
  const Track loop({{0, {0, 0, 0}, {}, {}},
                    {100, {1000, 0, 0}, {}, {}},
                    {150, {1000, 500, 0}, {}, {}},
                    {200, {500, 500, 0}, {}, {}},
                    {300, {500, -500, 0}, {}, {}}});
  const auto on_it = followed(0, 300, 1, [&](double t) { return loop.at(t).position_m; });
  const Deviation deviation = deviation_from(loop, {}, on_it);
  EXPECT_NEAR(deviation.across.most_m, 0, 1e-9);
  EXPECT_NEAR(deviation.along.most_m, 0, 1e-9);
}

TEST(Deviation, TheWayIsTheSmoothCurveNotItsChords) {
  // A quarter of a circle of 500 m in 100 s, told by its ends alone: chords would be off by 146 m.
  const double speed = 500 * constants::pi / 2 / 100;
  const Track arc({{0, {500, 0, 0}, Triple<double>{0, speed, 0}, {}},
                   {100, {0, 500, 0}, Triple<double>{-speed, 0, 0}, {}}});
  const auto circle = followed(0, 100, 1, [](double t) {
    const double angle = constants::pi / 2 * t / 100;
    return Triple<double>{500 * std::cos(angle), 500 * std::sin(angle), 0};
  });
  // Hermite's remainder is at most R theta^4/384 = 7.9 m.
  EXPECT_LT(deviation_from(arc, {}, circle).across.most_m, 8);
}

TEST(Deviation, WhereTheTrackIsUnknownNothingIsCounted) {
  const Track gap({{0, {0, 0, 0}, {}, {}},
                   {100, {100, 0, 0}, {}, {}},
                   {1000, {1000, 0, 0}, {}, {}},
                   {1100, {1100, 0, 0}, {}, {}}});
  const auto way = followed(-50, 1150, 1, [](double t) { return Triple<double>{t, 7, 0}; });
  const Deviation deviation = deviation_from(gap, {}, way);
  EXPECT_EQ(deviation.samples, 202U);
  EXPECT_EQ(deviation.unknown, way.size() - 202);
  EXPECT_NEAR(deviation.across.mean_m, 7, 1e-9);
  EXPECT_NEAR(deviation.along.most_m, 0, 1e-9);
  EXPECT_EQ(deviation_from(gap, {}, {}).samples, 0U);
}

TEST(Deviation, ATrackThatNeverMovesHasADistanceAndNoSide) {
  const Track moored({{0, {10, 10, 0}, {}, {}}, {100, {10, 10, 0}, {}, {}}});
  const auto near = followed(0, 100, 1, [](double) { return Triple<double>{13, 6, 0}; });
  const Deviation deviation = deviation_from(moored, {}, near);
  EXPECT_NEAR(deviation.across.mean_m, 5, 1e-12);
  EXPECT_EQ(deviation.along.most_m, 0);
  const Track one({{0, {10, 10, 0}, {}, {}}});
  EXPECT_NEAR(deviation_from(one, {},
                             followed(0, 0, 1,
                                      [](double) {
                                        return Triple<double>{13, 6, 0};
                                      }))
                  .across.mean_m,
              5, 1e-12);
  EXPECT_THROW((void)deviation_from(Track(), {}, near), ContractViolation);
}

TEST(Deviation, StopsOnTheWayDoNoHarm) {
  const Track stopping({{0, {0, 0, 0}, {}, {}},
                        {60, {0, 0, 0}, {}, {}},
                        {160, {500, 0, 0}, {}, {}},
                        {260, {500, 0, 0}, {}, {}},
                        {360, {1000, 0, 0}, {}, {}},
                        {400, {1000, 0, 0}, {}, {}}});
  const auto beside = followed(0, 400, 1, [&](double t) {
    return stopping.at(t).position_m + Triple<double>{0, -3, 0};
  });
  const Deviation deviation = deviation_from(stopping, {}, beside);
  EXPECT_EQ(deviation.samples, 401U);
  EXPECT_NEAR(deviation.across.mean_m, -3, 1e-9);
  EXPECT_NEAR(deviation.across.rms_m, 3, 1e-9);
  EXPECT_NEAR(deviation.along.most_m, 0, 1e-9);
}

/// A craft that does at once what it is told, in a current; the distances to the track at each
/// step.
std::vector<double> distances_of_pursuit(const Pursuit& pursuit, const Triple<double>& start,
                                         const Triple<double>& current, double dt_s,
                                         double until_s) {
  const Track track = diagonal();
  Triple<double> position = start;
  std::vector<double> distances;
  double yaw = 0;
  for (int step = 0; step * dt_s <= until_s; ++step) {
    const TrackState wanted = track.at(step * dt_s);
    distances.push_back(
        std::hypot(wanted.position_m.x - position.x, wanted.position_m.y - position.y));
    const Heading heading = pursue(pursuit, wanted, position, current, yaw);
    yaw = heading.yaw_rad;
    const Triple<double> through{heading.speed_m_s * std::cos(yaw),
                                 heading.speed_m_s * std::sin(yaw), 0};
    position = position + dt_s * (through + current);
  }
  return distances;
}

TEST(Pursuit, TheDistanceDiesAwayExponentiallyAlsoInACurrent) {
  for (const Triple<double>& current : {Triple<double>{0, 0, 0}, Triple<double>{-0.8, 0.5, 0}}) {
    const auto distances = distances_of_pursuit({0.1, 50, 0.05}, {30, -40, 0}, current, 0.01, 60);
    EXPECT_NEAR(distances[1000], 50 * std::exp(-1),
                0.02);  // explicit steps: 50 (k dt/2) k t e^-kt = 0.01
    EXPECT_NEAR(distances[3000], 50 * std::exp(-3), 0.02);
  }
}

TEST(Pursuit, ACurrentThatNobodyTellsOfIsLearned) {
  // With e = p_track - p: e' = -k e + d - c and d' = -k^2/4 e, from rest on the track: e = -c t
  // exp(-k t/2).
  const Pursuit pursuit{0.1, 50, 0.05};
  const Triple<double> current{-0.8, 0.5, 0};
  constexpr double dt_s = 0.01;
  Triple<double> position, drift;
  TrackState wanted;
  wanted.status = TrackStatus::on_track;
  wanted.velocity_m_s = {3, 1, 0};
  for (int i = 0; i < 12'000; ++i) {
    const double t_s = i * dt_s;
    wanted.position_m = t_s * wanted.velocity_m_s;
    if (i % 1000 == 0) {
      const double off = std::hypot(current.x, current.y) * t_s * std::exp(-0.05 * t_s);
      EXPECT_NEAR(std::hypot(position.x - wanted.position_m.x, position.y - wanted.position_m.y),
                  off, 0.01);
    }
    learn_drift(pursuit, wanted, position, dt_s, drift);
    const Heading heading = pursue(pursuit, wanted, position, drift, 0);
    position = position + dt_s * (heading.speed_m_s * Triple<double>{std::cos(heading.yaw_rad),
                                                                     std::sin(heading.yaw_rad), 0} +
                                  current);
  }
  EXPECT_NEAR(drift.x, current.x, 0.02);
  EXPECT_NEAR(drift.y, current.y, 0.02);
  // What its speed cannot do teaches it nothing, and nothing teaches it more than half of its
  // speed.
  Triple<double> none;
  learn_drift({0.1, 2, 0.05}, wanted, position, 1, none);
  EXPECT_EQ(none.x, 0);
  wanted.velocity_m_s = {};
  for (int i = 0; i < 10'000; ++i)
    learn_drift({0.1, 2, 0.05}, wanted, wanted.position_m - Triple<double>{0.1, 0, 0}, 1, none);
  EXPECT_EQ(none.x, -1);
}

TEST(Deviation, BesideAWayThatComesBackItIsFromTheOneThatIsUnderWay) {
  // Out to the north and back 8 m to the east of that; the follower is nearer to the way back.
  const Track hairpin({{0, {0, 0, 0}, {}, {}},
                       {300, {300, 0, 0}, {}, {}},
                       {308, {300, 8, 0}, {}, {}},
                       {608, {0, 8, 0}, {}, {}}});
  const FollowedPoint at{200, {200, 5, 0}};
  const Deviation d = deviation_from(hairpin, {}, {&at, 1}, 500, 4.9);
  EXPECT_NEAR(d.across.mean_m, 5, 1e-9);
  EXPECT_NEAR(d.along.mean_m, 0, 1e-9);
  EXPECT_NEAR(d.apart.mean_m, 5, 1e-9);
  EXPECT_EQ(d.within, 0U);
  EXPECT_EQ(deviation_from(hairpin, {}, {&at, 1}, 500, 5.1).within, 1U);
}

TEST(Pursuit, ASlowCraftFallsBehindAtTheDifferenceOfSpeeds) {
  const auto distances = distances_of_pursuit({0.1, 4, 0.05}, {0, 0, 0}, {0, 0, 0}, 0.1, 500);
  EXPECT_NEAR(distances[5000] - distances[4000], 100 * (5 - 4), 0.1);
}

TEST(Pursuit, AtRestTheBowStaysWhereItIs) {
  TrackState moored;
  moored.status = TrackStatus::on_track;
  EXPECT_EQ(pursue({0.1, 5, 0.05}, moored, {0.1, 0, 0}, {0, 0, 0}, 2.5).yaw_rad, 2.5);
  EXPECT_NEAR(pursue({0.1, 5, 0.05}, moored, {10, 0, 0}, {0, 0, 0}, 2.5).yaw_rad, constants::pi,
              1e-12);
  EXPECT_THROW((void)pursue({0.1, 5, 0.05}, TrackState{}, {}, {}, 0), ContractViolation);
}

}  // namespace
}  // namespace slackwater::tests::deviation_test
