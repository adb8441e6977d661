// `speed_m_s` of an AUV and of a surface craft is its speed through the water, as it is of every
// such craft at sea: the water then carries it further or less far for the same energy.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "tests/twin/validation/flight.h"

namespace slackwater::twin::speed_through_water_test {
namespace {

using tests::Flight;

/// Northward in a current of (east, north) m/s. @param speed  a key with its value
Scenario northward(const char* model, const std::string& speed, double east_m_s, double north_m_s,
                   double depth_m) {
  char yaml[900];
  std::snprintf(yaml, sizeof yaml, R"(
name: north
seed: 1
duration: 2h
step_s: 0.05
water: {made_up: {depth_m: 100, current: [{depth_m: 0, east_m_s: %g, north_m_s: %g}]}}
vehicles:
  - name: it
    model: %s
    %s
    start: {north_m: 0, east_m: 0, depth_m: %g, heading_deg: 0}
    tasks: [{do: route, waypoints: [{north_m: 20000, east_m: 0, depth_m: %g}]}]
)",
                east_m_s, north_m_s, model, speed.c_str(), depth_m, depth_m);
  return parse_scenario(yaml, "north");
}

/// Means over a minute after it has come to rest in its motion.
struct Steady {
  double over_ground_m_s = 0;
  double through_m_s = 0;
  double power_w = 0;
  double fuel_g_m = 0;
  double least_thrust_n = 1e9;
  double off_track_m = 0;
  double off_depth_m = 0;
  [[nodiscard]] double per_metre_j() const { return power_w / over_ground_m_s; }
};
Steady settled(const Scenario& scenario, double after_s = 300) {
  Flight flight(scenario);
  Steady s;
  while (flight.time_s() < after_s) {
    flight.step();
    s.least_thrust_n = std::min(s.least_thrust_n, flight.thrust_n().x);
  }
  const double from_s = flight.time_s(), from_m = flight.body().position_m.x,
               from_j = flight.vehicle().drawn_j, from_kg = flight.vehicle().fuel_kg;
  const Triple<double> current = flight.agent().water->current({0, 0, 20}, 0, 0).current_m_s;
  constexpr int steps = 1200;
  for (int i = 0; i < steps; ++i) {
    flight.step();
    const Triple<double> through = flight.velocity_m_s() - current;
    s.through_m_s += std::sqrt(dot(through, through)) / steps;
    s.least_thrust_n = std::min(s.least_thrust_n, flight.thrust_n().x);
    s.off_track_m = std::max(s.off_track_m, std::abs(flight.body().position_m.y));
    s.off_depth_m = std::max(s.off_depth_m,
                             std::abs(flight.body().position_m.z - scenario.vehicles[0].start_m.z));
  }
  const double passed_s = flight.time_s() - from_s;
  s.over_ground_m_s = (flight.body().position_m.x - from_m) / passed_s;
  s.fuel_g_m = 1000 * (flight.vehicle().fuel_kg - from_kg) / (s.over_ground_m_s * passed_s);
  s.power_w = (flight.vehicle().drawn_j - from_j) / passed_s;
  return s;
}

TEST(SpeedThroughTheWater, TheWaterCarriesAVehicleForTheSamePower) {
  struct Craft {
    const char* model;
    double speed_m_s;
    double depth_m;
  };
  std::printf("model, through the water, current, over ground m/s, W, J/m, g/m of fuel\n");
  for (const Craft& craft :
       {Craft{"lrauv_tethys", 1.0, 20}, Craft{"wamv16", 1.5, 0}, Craft{"ctv24", 8, 0}}) {
    const std::string speed = "speed_m_s: " + std::to_string(craft.speed_m_s);
    const Steady still = settled(northward(craft.model, speed, 0, 0, craft.depth_m));
    for (const double along : {-0.5, 0.0, 0.5, 1.2}) {
      if (along > 1 && craft.depth_m == 0) continue;
      const Steady s = settled(northward(craft.model, speed, 0, along, craft.depth_m));
      std::printf("%s, %g, %+g, %.3f, %.1f, %.1f, %.3f\n", craft.model, craft.speed_m_s, along,
                  s.over_ground_m_s, s.power_w, s.per_metre_j(), s.fuel_g_m);
      EXPECT_NEAR(s.fuel_g_m * s.over_ground_m_s, still.fuel_g_m * still.over_ground_m_s,
                  0.01 * still.fuel_g_m * still.over_ground_m_s + 1e-9)
          << along;
      EXPECT_NEAR(s.through_m_s, craft.speed_m_s, 0.005 * craft.speed_m_s) << along;
      EXPECT_NEAR(s.over_ground_m_s, craft.speed_m_s + along, 0.005 * craft.speed_m_s) << along;
      EXPECT_NEAR(s.power_w, still.power_w, 0.01 * still.power_w + 0.01) << along;
      EXPECT_GE(s.least_thrust_n, -1e-6) << "astern in a following current: " << along;
    }
  }
}

TEST(SpeedThroughTheWater, AnAuvKeepsItsDepthInAFollowingCurrentThatIsFasterThanItself) {
  const Steady s = settled(northward("lrauv_tethys", "speed_m_s: 1", 0, 1.2, 20));
  EXPECT_NEAR(s.over_ground_m_s, 2.2, 0.01);
  EXPECT_LT(s.off_depth_m, 0.2);
  EXPECT_LT(s.off_track_m, 0.5);
}

TEST(SpeedThroughTheWater, ALineIsHeldInACrossCurrentByCrabbing) {
  for (const auto& [model, speed, depth] :
       {std::tuple{"lrauv_tethys", 1.0, 20.0}, std::tuple{"wamv16", 1.5, 0.0}}) {
    const double across = 0.6 * speed;
    const Steady s =
        settled(northward(model, "speed_m_s: " + std::to_string(speed), across, 0, depth), 600);
    EXPECT_LT(s.off_track_m, 1) << model;
    EXPECT_NEAR(s.through_m_s, speed, 0.01 * speed) << model;
    EXPECT_NEAR(s.over_ground_m_s, 0.8 * speed, 0.01 * speed) << model;  // 3-4-5
  }
}

TEST(SpeedThroughTheWater, GroundSpeedIsKeptOverGroundAndNeverAstern) {
  for (const auto& [model, depth] : {std::tuple{"lrauv_tethys", 20.0}, std::tuple{"wamv16", 0.0}}) {
    for (const double along : {-0.3, 0.3}) {
      const Steady s = settled(northward(model, "ground_speed_m_s: 0.7", 0, along, depth));
      EXPECT_NEAR(s.over_ground_m_s, 0.7, 0.01) << model << along;
      EXPECT_LT(s.off_depth_m, depth > 0 ? 0.2 : 1) << model << along;
    }
    // Faster water than was asked for carries it along. What steers by fins keeps way on for them;
    // what floats drifts, its thrusters at rest, and the air holds it back as hard as the water
    // pushes: 0.5 (1.2 - s)^2 = (51.3 + 72.4 s) s of a WAM-V.
    constexpr double slip_m_s = 0.013466;
    const Steady swept = settled(northward(model, "ground_speed_m_s: 0.7", 0, 1.2, depth));
    EXPECT_GE(swept.least_thrust_n, -1e-6) << model;
    if (depth > 0) {
      EXPECT_GT(swept.over_ground_m_s, 1.2) << model;
    } else {
      EXPECT_NEAR(swept.over_ground_m_s, 1.2 - slip_m_s, 1e-5) << model;
    }
    EXPECT_LT(swept.off_track_m, 1) << model;
  }
  const Steady across =
      settled(northward("lrauv_tethys", "ground_speed_m_s: 0.6", 0.5, 0, 20), 600);
  EXPECT_NEAR(across.over_ground_m_s, 0.6, 0.01);
  EXPECT_LT(across.off_track_m, 1);
}

TEST(SpeedThroughTheWater, WaterFasterThanTheVehicleEndsTheRunAsNoHeadway) {
  // Ahead, and across: nowhere does it go astern, and neither run goes on to its end.
  for (const auto& [east, north] : {std::pair{0.0, -1.2}, std::pair{1.2, 0.0}}) {
    Flight flight(northward("lrauv_tethys", "speed_m_s: 1", east, north, 20));
    double least_n = 1e9;
    while (flight.state().halt == Halt::none && flight.time_s() < 3600) {
      flight.step();
      least_n = std::min(least_n, flight.thrust_n().x);
    }
    EXPECT_EQ(flight.state().halt, Halt::no_headway) << east;
    EXPECT_LT(flight.time_s(), 700) << east;
    EXPECT_GE(least_n, -1e-6) << east;
  }
  // A current that it just beats is none.
  Flight beats(northward("lrauv_tethys", "speed_m_s: 1", 0, -0.9, 20));
  beats.run(1500);
  EXPECT_EQ(beats.state().halt, Halt::none);
  EXPECT_GT(beats.body().position_m.x, 100);
}

TEST(SpeedThroughTheWater, OfAPlaceThatCannotBeHeldTheRunEndsToo) {
  Scenario scenario = northward("lrauv_tethys", "speed_m_s: 1", 0, 1.4, 20);
  scenario.vehicles[0].tasks[0].kind = ScenarioTask::Kind::hold;
  scenario.vehicles[0].tasks[0].waypoints.clear();
  scenario.vehicles[0].tasks[0].hold_s = 1e9;
  Flight flight(scenario);
  while (flight.state().halt == Halt::none && flight.time_s() < 3600) flight.step();
  EXPECT_EQ(flight.state().halt, Halt::no_headway);
}

TEST(SpeedThroughTheWater, ByItsOwnInstrumentsItGoesByItsDopplerLogOrByItsPropeller) {
  // The AUV's DVL hears the water below it; a WAM-V has none, and goes by the thrust that its speed
  // takes in still water. Without wind both come to the same.
  for (const auto& [model, speed, depth] :
       {std::tuple{"lrauv_tethys", 1.0, 20.0}, std::tuple{"wamv16", 1.5, 0.0}}) {
    const Steady s = settled(northward(
        model, "speed_m_s: " + std::to_string(speed) + "\n    navigation: sensors", 0, 0.5, depth));
    EXPECT_NEAR(s.through_m_s, speed, 0.02 * speed) << model;
    EXPECT_NEAR(s.over_ground_m_s, speed + 0.5, 0.02 * speed) << model;
  }
}

TEST(SpeedThroughTheWater, RovsAndMultirotorsGoOverGround) {
  const Steady rov = settled(northward("bluerov2_heavy", "speed_m_s: 0.5", 0, 0.2, 20), 30);
  EXPECT_NEAR(rov.over_ground_m_s, 0.5, 0.01);
}

}  // namespace
}  // namespace slackwater::twin::speed_through_water_test
