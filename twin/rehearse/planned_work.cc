#include "twin/rehearse/planned_work.h"

#include <cmath>
#include <utility>

namespace slackwater::twin {

PhasePlan plan_of(const Triple<double>& start_m, const Mission& mission) {
  PhasePlan plan;
  Triple<double> is_at_m = start_m;
  bool is_carried = false;
  for (const ScenarioTask& task : mission.tasks) {
    is_carried = is_carried || task.until_stand_by;
    double duration_s = std::isfinite(task.hold_s) ? task.hold_s : 0;
    for (const Waypoint& to : task.waypoints) {
      const double speed_m_s = to.speed_m_s > 0 ? to.speed_m_s : mission.guidance.speed_m_s;
      if (speed_m_s > 0 && !is_carried)
        duration_s += length_of(to.position_m - is_at_m) / speed_m_s;
      is_at_m = to.position_m;
      is_carried = false;
    }
    if (!plan.phases.empty() && plan.phases.back().phase == task.phase)
      plan.phases.back().duration_s += duration_s;
    else
      plan.phases.push_back({task.phase, duration_s});
  }
  return plan;
}

namespace {

/// Courses of a vehicle's legs and, as long as it stays somewhere, of the last one before.
class Bows {
 public:
  void go(const Triple<double>& from_m, const Triple<double>& to_m, bool counts) {
    const LegPlace leg = place_on_leg(from_m, to_m, from_m);
    if (!(leg.length_m > 0)) return;
    last_ = leg.course;
    if (counts) ways_.push_back(leg.course);
  }
  void stay() {
    if (last_) stays_.push_back(*last_);
  }
  [[nodiscard]] std::vector<Course> all() && { return std::move(stays_.empty() ? ways_ : stays_); }

 private:
  std::optional<Course> last_;
  std::vector<Course> ways_, stays_;
};

}  // namespace

std::optional<PhaseReach> reach_in(const Triple<double>& start_m, const Mission& mission,
                                   Phase phase) {
  std::optional<PhaseReach> reach;
  Triple<double> sum_m;
  double count = 0;
  const auto hold = [&](const Triple<double>& place_m) {
    if (!reach) reach = PhaseReach{place_m, place_m, place_m, {}};
    if (place_m.z < reach->highest_m.z) reach->highest_m = place_m;
    if (place_m.z > reach->lowest_m.z) reach->lowest_m = place_m;
  };
  Bows bows;
  Triple<double> is_at_m = start_m;
  for (const ScenarioTask& task : mission.tasks) {
    Triple<double> from_m = is_at_m;
    for (const Waypoint& at : task.waypoints) {
      bows.go(from_m, at.position_m, task.phase == phase);
      from_m = at.position_m;
    }
    if (task.phase == phase) {
      if (task.waypoints.empty()) bows.stay();
      hold(is_at_m);
      for (const Waypoint& at : task.waypoints) {
        hold(at.position_m);
        sum_m = sum_m + at.position_m;
        ++count;
      }
    }
    if (!task.waypoints.empty()) is_at_m = task.waypoints.back().position_m;
  }
  if (count > 0) reach->middle_m = (1 / count) * sum_m;
  if (reach) reach->bows = std::move(bows).all();
  return reach;
}

}  // namespace slackwater::twin
