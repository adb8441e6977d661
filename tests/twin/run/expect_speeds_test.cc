#include "twin/run/expect_speeds.h"

#include "fields/base/error.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::expect_speeds_test {
namespace {

/// What is said of a vehicle that is to go that fast; `speed` is a key with its value.
std::string refusal(const std::string& model, const std::string& speed,
                    const std::string& of_waypoint = "") {
  const std::string height = model == "x500" ? "height_m" : "depth_m";
  try {
    (void)tests::ready_of(
        tests::calm_head(0.05) + "  - {name: it, model: " + model +
        (speed.empty() ? "" : ", " + speed) + ", start: {north_m: 0, east_m: 0, " + height +
        ": 10}, tasks: [{do: route, waypoints: [{north_m: 50, east_m: 0, " + height + ": 10" +
        (of_waypoint.empty() ? "" : ", " + of_waypoint) + "}]}]}\n");
  } catch (const Error& problem) {
    EXPECT_EQ(problem.kind(), ErrorKind::invalid_input);
    return problem.message();
  }
  return "nothing was refused";
}

TEST(ExpectSpeeds, FasterThanAVehicleMakesIsRefusedWithWhatItMakes) {
  for (const char* model : {"bluerov2_heavy", "lrauv_tethys", "x500", "wamv16", "ctv24"}) {
    for (const auto& [of_vehicle, of_waypoint] :
         {std::pair<std::string, std::string>{"speed_m_s: 30", ""},
          {"", "speed_m_s: 30"},
          {"ground_speed_m_s: 30", ""},
          {"", "ground_speed_m_s: 30"}}) {
      const std::string message = refusal(model, of_vehicle, of_waypoint);
      for (const char* says : {"vehicle it", "found 30 m/s", "expected at most", "Ask for less"})
        EXPECT_NE(message.find(says), std::string::npos) << model << "\n-> " << message;
      EXPECT_EQ(message.find("waypoint 1 of task 1") != std::string::npos, !of_waypoint.empty())
          << message;
    }
  }
}

TEST(ExpectSpeeds, WhatAVehicleMakesIsNot) {
  // The published speeds of twin/docs/vehicles.md, and what the bundled scenarios ask for.
  for (const auto& [model, speed] : {std::pair{"bluerov2_heavy", "speed_m_s: 1.1"},
                                     {"bluerov2_heavy", "hold_bus_v: 16, speed_m_s: 1.49"},
                                     {"lrauv_tethys", "speed_m_s: 1.0"},
                                     {"lrauv_tethys", "ground_speed_m_s: 1.8"},
                                     {"x500", "speed_m_s: 12"},
                                     {"wamv16", "speed_m_s: 2.1"},
                                     {"ctv24", "speed_m_s: 11.3"}})
    EXPECT_EQ(refusal(model, speed), "nothing was refused") << model << " " << speed;
}

TEST(ExpectSpeeds, AnAuvThatItsFinsCannotSteerIsRefused) {
  const std::string message = refusal("lrauv_tethys", "speed_m_s: 0.1");
  EXPECT_NE(message.find("at least 0.3 m/s"), std::string::npos) << message;
}

}  // namespace
}  // namespace slackwater::twin::expect_speeds_test
