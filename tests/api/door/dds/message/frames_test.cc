#include "api/door/dds/message/frames.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "fields/base/numbers/random.h"

// NED with bodies forward, right, down (Fossen) to ENU with bodies forward, left, up (REP-103),
// against matrices: what a quaternion of ROS means is said by ROS's formulas, not by ours.

namespace slackwater::dds::frames_test {
namespace {

constexpr double quarter = std::numbers::pi / 2;

Eigen::Vector3d eigen(const twin::Triple<double>& v) { return {v.x, v.y, v.z}; }
Eigen::Matrix3d matrix(const twin::Attitude<double>& q) {
  return Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
}
/// Columns: where east, north and up of a NED vector come from.
Eigen::Matrix3d enu_from_ned() {
  Eigen::Matrix3d m;
  m << 0, 1, 0, 1, 0, 0, 0, 0, -1;
  return m;
}
Eigen::Matrix3d frd_from_flu() { return Eigen::Vector3d(1, -1, -1).asDiagonal(); }

/// Fixed axes x, y, z, as tf2 has them: forward, left, up.
struct RosAngles {
  double roll, pitch, yaw;
};
RosAngles angles_of(const twin::Attitude<double>& enu_flu) {
  const Eigen::Matrix3d r = matrix(enu_flu);
  return {std::atan2(r(2, 1), r(2, 2)), -std::asin(r(2, 0)), std::atan2(r(1, 0), r(0, 0))};
}
RosAngles lying(double roll, double pitch, double heading) {
  return angles_of(enu_flu_ned_frd(twin::attitude_of({roll, pitch, heading})));
}

twin::Attitude<double> any_attitude(Rng& random) {
  return twin::normalised<double>(
      {random.normal(), random.normal(), random.normal(), random.normal()});
}

TEST(FramesOfRos, TurnVectorsAsTheMatricesDoBothWays) {
  Rng random(1, "tests/dds/frames");
  for (int i = 0; i < 1000; ++i) {
    const twin::Triple<double> v{random.normal(), random.normal(), random.normal()};
    EXPECT_EQ(eigen(enu_ned(v)), enu_from_ned() * eigen(v));
    EXPECT_EQ(eigen(flu_frd(v)), frd_from_flu() * eigen(v));
    EXPECT_EQ(eigen(enu_ned(enu_ned(v))), eigen(v));
    EXPECT_EQ(eigen(flu_frd(flu_frd(v))), eigen(v));
  }
}

TEST(FramesOfRos, TurnAttitudesAsTheMatricesDo) {
  Rng random(2, "tests/dds/frames");
  for (int i = 0; i < 10'000; ++i) {
    const twin::Attitude<double> q = any_attitude(random);
    const Eigen::Matrix3d expected = enu_from_ned() * matrix(q) * frd_from_flu();
    const twin::Attitude<double> turned = enu_flu_ned_frd(q);
    EXPECT_LT((matrix(turned) - expected).cwiseAbs().maxCoeff(), 1e-14);  // rounding
    EXPECT_GE(turned.w, 0);
  }
}

TEST(FramesOfRos, AttitudesCameBackFromWhereTheyWent) {
  Rng random(3, "tests/dds/frames");
  for (int i = 0; i < 10'000; ++i) {
    const twin::Attitude<double> q = any_attitude(random);
    const twin::Attitude<double> back = enu_flu_ned_frd(enu_flu_ned_frd(q));
    EXPECT_LT((matrix(back) - matrix(q)).cwiseAbs().maxCoeff(), 1e-14);
    EXPECT_NEAR(back.w * back.w + back.x * back.x + back.y * back.y + back.z * back.z, 1, 1e-14);
  }
}

TEST(FramesOfRos, YawIsCountedFromEastToNorth) {
  EXPECT_NEAR(lying(0, 0, 0).yaw, quarter, 1e-15);  // to the north
  EXPECT_NEAR(lying(0, 0, quarter).yaw, 0, 1e-15);  // to the east
  EXPECT_NEAR(lying(0, 0, -quarter).yaw, 2 * quarter, 1e-15);
  EXPECT_NEAR(lying(0, 0, 2 * quarter).yaw, -quarter, 1e-15);  // to the south
}

TEST(FramesOfRos, NoseUpIsANegativePitchAndStarboardDownAPositiveRoll) {
  // About +y, which points left, a positive turn takes the nose down (REP-103 by the right hand).
  for (const double heading : {0.0, 1.0, -2.5}) {
    EXPECT_NEAR(lying(0, 0.3, heading).pitch, -0.3, 1e-14);
    EXPECT_NEAR(lying(0.3, 0, heading).roll, 0.3, 1e-14);
    EXPECT_NEAR(lying(0.3, 0.2, heading).yaw, std::remainder(quarter - heading, 4 * quarter),
                1e-14);
  }
}

TEST(FramesOfRos, ABodyThatLooksUpPointsUp) {
  const Eigen::Matrix3d r = matrix(enu_flu_ned_frd(twin::attitude_of({0, quarter, 0})));
  EXPECT_LT((r.col(0) - Eigen::Vector3d::UnitZ()).norm(), 1e-15);
}

}  // namespace
}  // namespace slackwater::dds::frames_test
