#include "twin/rehearse/planned_work.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace slackwater::twin {

PhasePlan plan_of(const Triple<double>& start_m, const Mission& mission) {
  PhasePlan plan;
  Triple<double> is_at_m = start_m;
  for (const ScenarioTask& task : mission.tasks) {
    double duration_s = std::isfinite(task.hold_s) ? task.hold_s : 0;
    for (const Waypoint& to : task.waypoints) {
      const double speed_m_s = to.speed_m_s > 0 ? to.speed_m_s : mission.guidance.speed_m_s;
      if (speed_m_s > 0) duration_s += length_of(to.position_m - is_at_m) / speed_m_s;
      is_at_m = to.position_m;
    }
    if (!plan.phases.empty() && plan.phases.back().phase == task.phase)
      plan.phases.back().duration_s += duration_s;
    else
      plan.phases.push_back({task.phase, duration_s});
  }
  return plan;
}

std::vector<Triple<double>> places_in(const Triple<double>& start_m, const Mission& mission,
                                      Phase phase) {
  Triple<double> sum_m;
  double count = 0;
  double highest_m = 0, lowest_m = 0;  // down
  std::optional<Triple<double>> stands_m;
  Triple<double> is_at_m = start_m;
  for (const ScenarioTask& task : mission.tasks) {
    if (task.phase == phase) {
      if (!stands_m) stands_m = is_at_m;
      for (const Waypoint& at : task.waypoints) {
        const Triple<double>& from_m = &at == task.waypoints.data() ? is_at_m : at.position_m;
        const auto [high_m, low_m] = std::minmax(from_m.z, at.position_m.z);
        highest_m = count > 0 ? std::min(highest_m, high_m) : high_m;
        lowest_m = count > 0 ? std::max(lowest_m, low_m) : low_m;
        sum_m = sum_m + at.position_m;
        ++count;
      }
    }
    if (!task.waypoints.empty()) is_at_m = task.waypoints.back().position_m;
  }
  if (!stands_m) return {};
  if (count == 0) return {*stands_m};
  const Triple<double> middle_m = (1 / count) * sum_m;
  const Triple<double> high_m{middle_m.x, middle_m.y, highest_m};
  if (highest_m == lowest_m) return {high_m};
  return {high_m, {middle_m.x, middle_m.y, lowest_m}};
}

}  // namespace slackwater::twin
