#pragma once
#include "tests/twin/run/run_for_tests.h"
#include "twin/agent/helm.h"
#include "twin/body/frame.h"

namespace slackwater::tests {

inline constexpr double helm_step_s = 0.05;

/// One vehicle without anything to do, in a current that is the same everywhere and without wind.
inline std::string lone(const std::string& model, const std::string& start, double east_m_s = 0,
                        double north_m_s = 0, const std::string& more = "") {
  return "name: test\nseed: 7\nduration: 60min\nstep_s: 0.05\nlog_every_s: 1\n"
         "water:\n  made_up:\n    depth_m: 60\n    current: [{depth_m: 0, east_m_s: " +
         std::to_string(east_m_s) + ", north_m_s: " + std::to_string(north_m_s) + "}]\n" + more +
         "vehicles:\n  - name: " + model + "\n    model: " + model + "\n    start: {" + start +
         "}\n    tasks: [{do: hold}]\n";
}

inline std::unique_ptr<twin::Run> lone_run(const std::string& yaml) {
  return begun(ready_of(yaml), helm_step_s);
}

/// Steps on, with the velocity asked for anew each half second.
inline void steer(twin::Run& run, const twin::HelmVelocity& velocity, double for_s) {
  const int steps = static_cast<int>(std::lround(for_s / helm_step_s));
  for (int i = 0; i < steps; ++i) {
    if (i % 10 == 0) run.enqueue({0, 0, twin::SetVelocity{velocity}});
    run.step();
  }
}

inline void go_on(twin::Run& run, double for_s) {
  const int steps = static_cast<int>(std::lround(for_s / helm_step_s));
  for (int i = 0; i < steps; ++i) run.step();
}

inline const twin::AgentState& state_of_lone(twin::Run& run) { return run.states()[0]; }

/// Over ground, NED, mean of some seconds.
inline twin::Triple<double> mean_velocity(twin::Run& run, const twin::HelmVelocity& velocity,
                                          double over_s) {
  const twin::Triple<double> from_m = state_of_lone(run).vehicle.body.position_m;
  steer(run, velocity, over_s);
  return (1 / over_s) * (state_of_lone(run).vehicle.body.position_m - from_m);
}

inline double yaw_rad(const twin::AgentState& state) {
  return twin::euler_angles(state.vehicle.body.attitude).yaw_rad;
}

}  // namespace slackwater::tests
