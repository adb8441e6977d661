#include "twin/traffic/track.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::tests::track_test {
namespace {

using namespace twin;
constexpr double pi = constants::pi;

double distance(const Triple<double>& a, const Triple<double>& b) {
  return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

TEST(Track, IsExactForMotionOfThirdDegree) {
  // Hermite's interpolation reproduces every cubic.
  const auto position = [](double t) {
    return Triple<double>{3 + 2 * t - 0.01 * t * t + 2e-5 * t * t * t,
                          -8 + 1.5 * t + 0.02 * t * t - 3e-5 * t * t * t, 0};
  };
  const auto velocity = [](double t) {
    return Triple<double>{2 - 0.02 * t + 6e-5 * t * t, 1.5 + 0.04 * t - 9e-5 * t * t, 0};
  };
  std::vector<TrackPoint> points;
  for (const double t : {10.0, 70.0, 95.0, 200.0})
    points.push_back({t, position(t), velocity(t), {}});
  const Track track(points);
  for (double t = 10; t <= 200; t += 0.7) {
    const TrackState state = track.at(t);
    ASSERT_TRUE(state.is_known());
    EXPECT_LT(distance(state.position_m, position(t)), 1e-10);
    EXPECT_LT(distance(state.velocity_m_s, velocity(t)), 1e-11);
  }
}

double error_on_circle(double interval_s) {
  constexpr double radius_m = 500;
  constexpr double rate_rad_s = 0.01;
  const auto position = [&](double t) {
    return Triple<double>{radius_m * std::cos(rate_rad_s * t), radius_m * std::sin(rate_rad_s * t),
                          0};
  };
  std::vector<TrackPoint> points;
  for (double t = 0; t < 700; t += interval_s) {
    const Triple<double> velocity{-radius_m * rate_rad_s * std::sin(rate_rad_s * t),
                                  radius_m * rate_rad_s * std::cos(rate_rad_s * t), 0};
    points.push_back({t, position(t), velocity, {}});
  }
  const Track track(points);
  double worst = 0;
  for (double t = 0; t < 600; t += 0.5)
    worst = std::max(worst, distance(track.at(t).position_m, position(t)));
  return worst;
}

TEST(Track, ItsErrorOnATurnFallsWithTheFourthPowerOfTheInterval) {
  // Of the remainder of Hermite's formula: T^4/384 |p''''| = R theta^4 / 384.
  EXPECT_NEAR(error_on_circle(60), 500 * std::pow(0.6, 4) / 384, 0.03 * error_on_circle(60));
  const double order = std::log2(error_on_circle(60) / error_on_circle(30));
  EXPECT_NEAR(order, 4, 0.1);
}

TEST(Track, WithoutVelocitiesOrByRuleTheWayIsStraight) {
  const Track bare({{0, {0, 0, 0}, {}, {}}, {10, {20, 40, 0}, {}, {}}});
  const Track curved({{0, {0, 0, 0}, Triple<double>{4, 0, 0}, {}},
                      {10, {20, 40, 0}, Triple<double>{0, 4, 0}, {}}});
  for (const auto& [track, rule] :
       {std::pair<const Track&, TrackRule>{bare, {}}, {curved, {TrackCurve::straight, 360}}}) {
    const TrackState state = track.at(2.5, rule);
    EXPECT_LT(distance(state.position_m, {5, 10, 0}), 1e-12);
    EXPECT_LT(distance(state.velocity_m_s, {2, 4, 0}), 1e-12);
  }
  EXPECT_GT(distance(curved.at(2.5).position_m, {5, 10, 0}), 1);
}

TEST(Track, AReportThatContradictsTheWayMadeDoesNotBendIt) {
  // 20 m/s reported, 1 m/s made good: Hermite would swing 180 m wide.
  const Track track({{0, {0, 0, 0}, Triple<double>{0, 20, 0}, {}},
                     {60, {60, 0, 0}, Triple<double>{0, -20, 0}, {}}});
  for (double t = 0; t <= 60; t += 1) EXPECT_LT(distance(track.at(t).position_m, {t, 0, 0}), 1e-12);
}

TEST(Track, SaysNothingOutsideItsReports) {
  const Track track(
      {{0, {0, 0, 0}, {}, {}}, {100, {100, 0, 0}, {}, {}}, {500, {500, 0, 0}, {}, {}}});
  const TrackRule rule{TrackCurve::smooth, 399};
  EXPECT_EQ(track.at(-0.001, rule).status, TrackStatus::before_start);
  EXPECT_EQ(track.at(0, rule).status, TrackStatus::on_track);
  EXPECT_EQ(track.at(100, rule).status, TrackStatus::on_track);
  EXPECT_DOUBLE_EQ(track.at(100, rule).velocity_m_s.x, 1) << "of the leg that ends here";
  EXPECT_EQ(track.at(100.001, rule).status, TrackStatus::in_gap);
  EXPECT_EQ(track.at(499.999, rule).status, TrackStatus::in_gap);
  EXPECT_EQ(track.at(500, rule).status, TrackStatus::on_track);
  EXPECT_EQ(track.at(500.001, rule).status, TrackStatus::after_end);
  EXPECT_EQ(track.at(300, {TrackCurve::smooth, 400}).status, TrackStatus::on_track);
  EXPECT_EQ(track.at(NAN, rule).status, TrackStatus::before_start);
  EXPECT_EQ(Track().at(0).status, TrackStatus::before_start);
  const Track one({{5, {1, 2, 0}, Triple<double>{3, 4, 0}, 1.0}});
  EXPECT_TRUE(one.at(5).is_known());
  EXPECT_EQ(one.at(5).velocity_m_s.y, 4);
  EXPECT_EQ(one.at(5.1).status, TrackStatus::after_end);
}

TEST(Track, HeadingsMeetAcrossNorth) {
  const double degree = pi / 180;
  const Track track({{0, {0, 0, 0}, {}, 350 * degree},
                     {10, {1, 0, 0}, {}, 10 * degree},
                     {20, {2, 0, 0}, {}, {}}});
  EXPECT_NEAR(*track.at(5).heading_rad, 0, 1e-12);
  EXPECT_NEAR(std::remainder(*track.at(0).heading_rad + 10 * degree, 2 * pi), 0, 1e-12);
  EXPECT_FALSE(track.at(15).heading_rad) << "one side does not know";
}

TEST(Track, RefusesPointsThatAreNoTrack) {
  EXPECT_THROW(Track({{1, {}, {}, {}}, {1, {}, {}, {}}}), ContractViolation);
  EXPECT_THROW(Track({{2, {}, {}, {}}, {1, {}, {}, {}}}), ContractViolation);
  EXPECT_THROW(Track({{NAN, {}, {}, {}}}), ContractViolation);
  EXPECT_THROW(Track({{1, {0, INFINITY, 0}, {}, {}}}), ContractViolation);
  EXPECT_THROW(Track({{1, {}, Triple<double>{NAN, 0, 0}, {}}}), ContractViolation);
  EXPECT_THROW(Track({{1, {}, {}, NAN}}), ContractViolation);
}

TEST(Track, NeverStraysFarFromTheLegWhateverIsReported) {
  // By the guard |v - c| <= |c| + 0.5, and T 4/27 is the most that each end's
  // term of Hermite's formula weighs.
  Rng rng(11, "tests/track");
  for (int round = 0; round < 2000; ++round) {
    const double period_s = rng.uniform(2, 360);
    const auto random_triple = [&](double most) {
      return Triple<double>{rng.uniform(-most, most), rng.uniform(-most, most), 0};
    };
    const Triple<double> end = random_triple(3000);
    const Track track(
        {{0, {0, 0, 0}, random_triple(15), {}}, {period_s, end, random_triple(15), {}}});
    const double bound_m = 2 * (4.0 / 27) * (distance(end, {}) + 0.5 * period_s);
    for (double u = 0; u <= 1; u += 0.05) {
      EXPECT_LE(distance(track.at(u * period_s).position_m, u * end), bound_m + 1e-9);
    }
  }
}

}  // namespace
}  // namespace slackwater::tests::track_test
