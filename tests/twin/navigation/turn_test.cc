#include "twin/navigation/turn.h"

#include <gtest/gtest.h>

#include "fields/base/numbers/random.h"

namespace slackwater::twin::turn_test {
namespace {

TEST(Turn, BetweenTwoAttitudesLeadsFromTheOneToTheOther) {
  Rng rng(3, "twin/turn_test");
  for (int i = 0; i < 200; ++i) {
    const double size = i % 3 == 0 ? 1e-9 : i % 3 == 1 ? 1e-4 : 3;
    const Attitude<double> from =
        attitude_of({rng.uniform(-3, 3), rng.uniform(-1.5, 1.5), rng.uniform(-3, 3)});
    const Triple<double> turn =
        (size / std::sqrt(3)) *
        Triple<double>{rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    const Triple<double> got = turn_between(from, turned(from, turn));
    EXPECT_NEAR(got.x, turn.x, 1e-15 + 1e-12 * size) << size;
    EXPECT_NEAR(got.y, turn.y, 1e-15 + 1e-12 * size) << size;
    EXPECT_NEAR(got.z, turn.z, 1e-15 + 1e-12 * size) << size;
  }
}

TEST(Turn, AboutTheDownAxisIsAYaw) {
  const EulerAngles angles = euler_angles(turned(attitude_of({0, 0, 0.3}), {0, 0, 0.4}));
  EXPECT_NEAR(angles.yaw_rad, 0.7, 1e-15);
  EXPECT_NEAR(angles.roll_rad, 0, 1e-15);
}

TEST(Turn, TheShorterWay) {
  const Attitude<double> q = attitude_of({0, 0, 0.3});
  const Triple<double> none = turn_between(q, {-q.w, -q.x, -q.y, -q.z});
  EXPECT_NEAR(none.z, 0, 1e-15);
}

}  // namespace
}  // namespace slackwater::twin::turn_test
