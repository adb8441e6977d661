#include "twin/vehicle/cruise_power.h"

#include "tests/twin/run/run_for_tests.h"
#include "twin/vehicle/top_speed.h"

namespace slackwater::tests::cruise_power_test {
namespace {

/// Power over the second half of two minutes on a straight way in still water or air.
struct Drawn {
  double mean_w = 0;
  double reckoned_w = 0;
};
Drawn drawn_by(const std::string& model, double speed_m_s, const std::string& level) {
  twin::ReadyRun ready = ready_of(calm_head(0.02) + "  - {name: v, model: " + model +
                                  ", start: {north_m: 0, east_m: 0, " + level +
                                  "}, speed_m_s: " + std::to_string(speed_m_s) +
                                  ", tasks: [{do: route, waypoints: [{north_m: "
                                  "5000, east_m: 0, " +
                                  level + "}]}]}\n");
  twin::Run run(std::move(ready.agents), std::move(ready.states), settings_of(0.02));
  while (run.time_s() < 60) run.step();
  const double half_j = run.states()[0].vehicle.drawn_j;
  while (run.time_s() < 120) run.step();
  const twin::Agent& agent = run.agents()[0];
  const double voltage_v = run.states()[0].vehicle.bus_voltage_v;
  return {(run.states()[0].vehicle.drawn_j - half_j) / 60,
          cruise_power_w(*agent.vehicle, *agent.autopilot, voltage_v, speed_m_s)};
}

TEST(CruisePower, IsWhatAVehicleDrawsOnAStraightWayInStillWater) {
  for (const auto& [model, speed_m_s, level] : {std::tuple{"bluerov2_heavy", 0.5, "depth_m: 10"},
                                                {"lrauv_tethys", 1.0, "depth_m: 10"},
                                                {"wamv16", 1.5, "depth_m: 0"},
                                                {"x500", 5.0, "height_m: 40"}}) {
    const Drawn drawn = drawn_by(model, speed_m_s, level);
    EXPECT_NEAR(drawn.reckoned_w, drawn.mean_w, 0.15 * drawn.mean_w) << model;
  }
}

TEST(CruisePower, OfAMultirotorAtRestIsThatOfItsHover) {
  const Drawn drawn = drawn_by("x500", 0.01, "height_m: 40");
  EXPECT_NEAR(drawn.reckoned_w, drawn.mean_w, 0.05 * drawn.mean_w);
}

TEST(CruisePower, GrowsWithTheSpeed) {
  twin::ReadyRun ready = ready_of(calm_head(0.05) +
                                  "  - {name: v, model: bluerov2_heavy, start: {north_m: 0, "
                                  "east_m: 0, depth_m: 10}}\n");
  const twin::Agent& agent = ready.agents[0];
  double before_w = 0;
  for (double speed_m_s = 0; speed_m_s < 1.3; speed_m_s += 0.1) {
    const double power_w = cruise_power_w(*agent.vehicle, *agent.autopilot, 16, speed_m_s);
    EXPECT_GT(power_w, before_w);
    before_w = power_w;
  }
}

}  // namespace
}  // namespace slackwater::tests::cruise_power_test
