#include "fields/base/constants.h"
#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::helm_velocity_test {
namespace {

using twin::HelmVelocity;
using twin::Triple;

struct Craft {
  const char* model;
  const char* start;
  double surge_m_s;
  double settle_s;
};
const std::string rov_start = "north_m: 0, east_m: 0, depth_m: 20, heading_deg: 30";
constexpr Craft crafts[] = {
    {"bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20, heading_deg: 30", 0.5, 20},
    {"lrauv_tethys", "north_m: 0, east_m: 0, depth_m: 20, heading_deg: 30", 0.9, 90},
    {"wamv16", "north_m: 0, east_m: 0, depth_m: 0, heading_deg: 30", 1.5, 60},
    {"ctv24", "north_m: 0, east_m: 0, depth_m: 0, heading_deg: 30", 4, 120},
};

/// Ahead of a heading.
Triple<double> ahead(double yaw, double surge_m_s) {
  return {std::cos(yaw) * surge_m_s, std::sin(yaw) * surge_m_s, 0};
}

TEST(HelmVelocity, IsReachedInStillWater) {
  for (const Craft& craft : crafts) {
    const auto run = lone_run(lone(craft.model, craft.start));
    const double yaw = yaw_rad(state_of_lone(*run));
    steer(*run, {craft.surge_m_s, 0, 0, 0}, craft.settle_s);
    const Triple<double> made = mean_velocity(*run, {craft.surge_m_s, 0, 0, 0}, 10);
    const Triple<double> off = made - ahead(yaw, craft.surge_m_s);
    EXPECT_LT(twin::length_of(off), 0.03 * craft.surge_m_s) << craft.model;
    EXPECT_EQ(state_of_lone(*run).halt, twin::Halt::none);
  }
}

TEST(HelmVelocity, IsThroughTheWaterWhichCarriesTheVehicle) {
  const Triple<double> water{-0.25, 0.4, 0};
  for (const Craft& craft : crafts) {
    for (const double surge : {craft.surge_m_s, 0.0}) {
      const auto run = lone_run(lone(craft.model, craft.start, water.y, water.x));
      const double yaw = yaw_rad(state_of_lone(*run));
      steer(*run, {surge, 0, 0, 0}, 2 * craft.settle_s);
      const Triple<double> made = mean_velocity(*run, {surge, 0, 0, 0}, 10);
      const Triple<double> off = made - (water + ahead(yaw, surge));
      EXPECT_LT(twin::length_of(off), 0.02 + 0.03 * surge) << craft.model << " at " << surge;
    }
  }
}

TEST(HelmVelocity, OfOneThatFliesIsOverGround) {
  const auto run = lone_run(lone("x500", "north_m: 0, east_m: 0, height_m: 30, heading_deg: 30"));
  const double yaw = yaw_rad(state_of_lone(*run));
  steer(*run, {2, 0, 0, 0}, 20);
  const Triple<double> made = mean_velocity(*run, {2, 0, 0, 0}, 10);
  EXPECT_LT(twin::length_of(made - ahead(yaw, 2)), 0.06);
}

TEST(HelmVelocity, GoesFasterOverGroundThanTheVehicleGoesItself) {
  // Drifting in 2 m/s is no speed of its own: an ROV of 1.4 m/s is not held back by its bound.
  const auto run = lone_run(lone("bluerov2_heavy", rov_start, 2, 0));
  steer(*run, {}, 30);
  EXPECT_NEAR(mean_velocity(*run, {}, 10).y, 2, 0.03);
}

TEST(HelmVelocity, OfOneThatGoesByItsInstrumentsIsThroughTheWaterThatItsLogShows) {
  const std::string east = "north_m: 0, east_m: 0, depth_m: 20, heading_deg: 90";
  const auto run = lone_run(lone("bluerov2_heavy", east, 0.3, 0, "navigation: sensors\n"));
  steer(*run, {0.4, 0, 0, 0}, 60);
  const Triple<double> made = mean_velocity(*run, {0.4, 0, 0, 0}, 30);
  EXPECT_NEAR(made.y, 0.7, 0.04);
  EXPECT_NEAR(made.x, 0, 0.04);
}

TEST(HelmVelocity, MovesAsideDownAndRound) {
  const auto run = lone_run(lone("bluerov2_heavy", rov_start));
  const double yaw = yaw_rad(state_of_lone(*run));
  steer(*run, {0, -0.3, 0.2, 0}, 20);
  const Triple<double> made = mean_velocity(*run, {0, -0.3, 0.2, 0}, 10);
  EXPECT_NEAR(made.x, 0.3 * std::sin(yaw), 0.01);
  EXPECT_NEAR(made.y, -0.3 * std::cos(yaw), 0.01);
  EXPECT_NEAR(made.z, 0.2, 0.01);
  steer(*run, {0, 0, 0, 0.2}, 10);
  const double before = yaw_rad(state_of_lone(*run));
  steer(*run, {0, 0, 0, 0.2}, 10);
  EXPECT_NEAR(std::remainder(yaw_rad(state_of_lone(*run)) - before - 2, 2 * constants::pi), 0,
              0.02);
}

TEST(HelmVelocity, KeepsHeadingAndDepthOnceItTurnsAndSinksNoMore) {
  const auto run = lone_run(lone("bluerov2_heavy", rov_start, 0.2, 0.1));
  steer(*run, {0.2, 0, 0.2, 0.3}, 15);
  steer(*run, {0.2, 0, 0, 0}, 15);
  const double yaw = yaw_rad(state_of_lone(*run));
  const double depth_m = state_of_lone(*run).vehicle.body.position_m.z;
  EXPECT_NEAR(state_of_lone(*run).helm.depth_m, depth_m, 0.02);
  steer(*run, {0.2, 0, 0, 0}, 60);
  EXPECT_NEAR(yaw_rad(state_of_lone(*run)), yaw, 0.01);
  EXPECT_NEAR(state_of_lone(*run).vehicle.body.position_m.z, depth_m, 0.02);
}

TEST(HelmVelocity, OfWhatSwimsEndsAtTheSurface) {
  const auto run =
      lone_run(lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 3, heading_deg: 30"));
  steer(*run, {0, 0, -0.3, 0}, 60);
  EXPECT_GT(state_of_lone(*run).vehicle.body.position_m.z, -0.15);
  EXPECT_LT(state_of_lone(*run).vehicle.body.position_m.z, 0.15);
}

TEST(HelmVelocity, TakesOverWithoutABump) {
  // An ROV on its way north at 0.5 m/s is asked for just that, and then to hold.
  std::string yaml = lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20");
  const std::string hold = "[{do: hold}]";
  yaml.replace(
      yaml.find(hold), hold.size(),
      "[{do: route, waypoints: [{north_m: 500, east_m: 0, depth_m: 20, speed_m_s: 0.5}]}]");
  const auto run = lone_run(yaml);
  go_on(*run, 30);
  const auto surge = [&] { return state_of_lone(*run).vehicle.body.nu.linear.x; };
  const double before = surge();
  for (int i = 0; i < 100; ++i) {
    steer(*run, {0.5, 0, 0, 0}, helm_step_s);
    ASSERT_NEAR(surge(), before, 0.01) << i;
  }
  EXPECT_NEAR(state_of_lone(*run).vehicle.body.position_m.y, 0, 0.02);
  // It slows down no faster than it is allowed.
  run->enqueue({0, 0, twin::HoldHere{}});
  const double most = run->agents()[0].autopilot->settings.most_acceleration_m_s2;
  for (int i = 0; i < 100; ++i) {
    const double was = surge();
    go_on(*run, helm_step_s);
    ASSERT_LT(std::abs(surge() - was), 2 * most * helm_step_s) << i;
  }
}

TEST(HelmVelocity, KeepsClearAllTheSame) {
  // A pile 30 m ahead, and a scenario that keeps clear: the helm does not drive into it.
  const std::string pile =
      "clearance: {structure_m: 3}\nstructures: [{name: pile, kind: cylinder, north_m: 30, east_m: "
      "0, diameter_m: 6, top_height_m: 20, bottom_depth_m: 60}]\n";
  const std::string start = "north_m: 0, east_m: 0, depth_m: 20";
  const auto run = lone_run(lone("bluerov2_heavy", start, 0, 0, pile));
  double nearest_m = 1e9;
  for (int i = 0; i < 240; ++i) {
    steer(*run, {0.5, 0, 0, 0}, 0.5);
    const twin::Triple<double>& at = state_of_lone(*run).vehicle.body.position_m;
    nearest_m = std::min(nearest_m, std::hypot(at.x - 30, at.y) - 3);
  }
  EXPECT_EQ(state_of_lone(*run).halt, twin::Halt::none);
  EXPECT_GT(nearest_m, 2.9);
  EXPECT_LT(nearest_m, 8);
}

}  // namespace
}  // namespace slackwater::tests::helm_velocity_test
