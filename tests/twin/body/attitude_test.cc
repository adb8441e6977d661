#include "twin/body/attitude.h"
#include "fields/base/turn.h"

#include <gtest/gtest.h>

#include "fields/base/constants.h"
#include "fields/base/numbers/random.h"

namespace slackwater::twin::attitude_test {
namespace {

using constants::pi;

Triple<double> random_triple(Rng& random) {
  return {random.normal(), random.normal(), random.normal()};
}
Attitude<double> random_attitude(Rng& random) {
  return normalised(
      Attitude<double>{random.normal(), random.normal(), random.normal(), random.normal()});
}
void expect_near(const Triple<double>& a, const Triple<double>& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(VehicleAttitude, HeadingEastTurnsForwardIntoEastAndRightIntoSouth) {
  const Rotation<double> r = rotation_of(attitude_of({0, 0, pi / 2}));
  expect_near(r.to_ned({1, 0, 0}), {0, 1, 0}, 1e-15);
  expect_near(r.to_ned({0, 1, 0}), {-1, 0, 0}, 1e-15);
}

TEST(VehicleAttitude, BowUpRaisesTheBowAndRollToStarboardLowersTheRightSide) {
  EXPECT_LT(rotation_of(attitude_of({0, 0.3, 0})).to_ned({1, 0, 0}).z, -0.29);
  EXPECT_GT(rotation_of(attitude_of({0.3, 0, 0})).to_ned({0, 1, 0}).z, 0.29);
}

TEST(VehicleAttitude, TurnsKeepLengthsAndComeBack) {
  Rng random(1, "tests/attitude");
  for (int i = 0; i < 200; ++i) {
    const Rotation<double> r = rotation_of(random_attitude(random));
    const Triple<double> v = random_triple(random);
    const Triple<double> turned = r.to_ned(v);
    EXPECT_NEAR(dot(turned, turned), dot(v, v), 1e-13 * dot(v, v));
    expect_near(r.to_body(turned), v, 1e-14 * (1 + dot(v, v)));
  }
}

TEST(VehicleAttitude, EulerAnglesComeBackButForTheVertical) {
  Rng random(2, "tests/attitude");
  for (int i = 0; i < 200; ++i) {
    const EulerAngles angles{random.uniform(-pi, pi), random.uniform(-1.5, 1.5),
                             random.uniform(-pi, pi)};
    const EulerAngles back = euler_angles(attitude_of(angles));
    EXPECT_NEAR(wrapped_rad(back.roll_rad - angles.roll_rad), 0, 1e-12);
    EXPECT_NEAR(back.pitch_rad, angles.pitch_rad, 1e-12);
    EXPECT_NEAR(wrapped_rad(back.yaw_rad - angles.yaw_rad), 0, 1e-12);
  }
}

/// dR v/dt = R (w x v), against a difference quotient of the quaternion's rate.
TEST(VehicleAttitude, TheRateIsThatOfTheRotation) {
  Rng random(3, "tests/attitude");
  for (int i = 0; i < 100; ++i) {
    const Attitude<double> q = random_attitude(random);
    const Triple<double> w = random_triple(random), v = random_triple(random);
    const Attitude<double> dq = rate_of(q, w);
    constexpr double dt = 1e-6;
    const auto moved = [&](double s) {
      return rotation_of(normalised(Attitude<double>{q.w + s * dq.w, q.x + s * dq.x, q.y + s * dq.y,
                                                     q.z + s * dq.z}))
          .to_ned(v);
    };
    const Triple<double> slope = (0.5 / dt) * (moved(dt) - moved(-dt));
    expect_near(slope, rotation_of(q).to_ned(cross(w, v)), 1e-8);
  }
}

}  // namespace
}  // namespace slackwater::twin::attitude_test
