#include "twin/scenario/laid_out_task.h"

#include <cmath>
#include <limits>

namespace slackwater::twin {
namespace {

constexpr double without_end_s = std::numeric_limits<double>::infinity();
constexpr double another_battery_w = std::numeric_limits<double>::infinity();

}  // namespace

double to_micrometre(double value) noexcept { return std::round(value * 1e6) / 1e6 + 0.0; }

Triple<double> to_micrometre(const Triple<double>& at_m) noexcept {
  return {to_micrometre(at_m.x), to_micrometre(at_m.y),
          at_m.z < 0 ? -to_micrometre(-at_m.z) : to_micrometre(at_m.z)};
}

ScenarioTask route_task(std::span<const Waypoint> waypoints, Phase phase, bool drifts) {
  ScenarioTask task;
  task.phase = phase;
  task.drifts = drifts;
  for (const Waypoint& at : waypoints)
    task.waypoints.push_back(
        {to_micrometre(at.position_m), at.speed_m_s > 0 ? to_micrometre(at.speed_m_s) : 0, 0});
  return task;
}

ScenarioTask hold_task(double duration_s, Phase phase) {
  ScenarioTask task;
  task.kind = ScenarioTask::Kind::hold;
  task.phase = phase;
  task.hold_s = to_micrometre(duration_s);
  return task;
}

ScenarioTask aboard_task(double duration_s, bool is_swapped, Phase phase) {
  ScenarioTask task = hold_task(duration_s, phase);
  task.kind = ScenarioTask::Kind::aboard;
  if (is_swapped) task.charger_w = another_battery_w;
  return task;
}

ScenarioTask carried_task(double least_s, bool is_swapped) {
  ScenarioTask task = aboard_task(least_s, is_swapped, Phase::transit);
  task.until_stand_by = true;
  return task;
}

ScenarioTask stand_by_task() {
  ScenarioTask task;
  task.kind = ScenarioTask::Kind::stand_by;
  task.hold_s = without_end_s;
  return task;
}

}  // namespace slackwater::twin
