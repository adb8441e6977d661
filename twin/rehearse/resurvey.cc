#include "twin/rehearse/resurvey.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fields/base/text.h"
#include "twin/inspection/resurvey_way.h"
#include "twin/mission/way_round.h"
#include "twin/scenario/laid_out_task.h"
#include "twin/scenario/write_scenario.h"

namespace slackwater::twin {
namespace {

constexpr double usual_speed_m_s = 0.3;
constexpr double spare = 1.5;  // of the time that a way takes by reckoning

struct NewWork {
  std::vector<ScenarioTask> tasks;
  double takes_s = 0;
};

/// The vehicle's tasks with its work replaced.
NewWork work_again(const ScenarioVehicle& entry, const ResurveyWay& way,
                   std::span<const Structure> structures) {
  NewWork work;
  const double asked_m_s = entry.speed_m_s.value_or(usual_speed_m_s);
  const double speed_m_s = way.asks_slower ? 0.5 * asked_m_s : asked_m_s;
  const double clear_m = entry.conduct ? entry.conduct->clear_m : 1;
  bool is_laid = false;
  Triple<double> at_m = entry.start_m;
  const auto lay = [&] {
    for (const ResurveyWay::Stand& stand : way.stands) {
      const auto leg = way_round(at_m, stand.place_m, structures, clear_m, speed_m_s);
      for (const Waypoint& waypoint : leg) {
        work.takes_s += length_of(waypoint.position_m - at_m) / speed_m_s;
        at_m = waypoint.position_m;
      }
      work.tasks.push_back(route_task(leg, is_laid ? Phase::work : Phase::transit));
      if (stand.stay_s > 0) work.tasks.push_back(hold_task(stand.stay_s, Phase::work));
      work.takes_s += stand.stay_s;
      is_laid = true;
    }
    const auto home = way_round(at_m, entry.start_m, structures, clear_m, asked_m_s);
    work.tasks.push_back(route_task(home, Phase::return_home));
  };
  for (const ScenarioTask& task : entry.tasks) {
    if (task.phase == Phase::launch || task.phase == Phase::recovery) {
      if (task.phase == Phase::recovery && !is_laid) lay();
      work.tasks.push_back(task);
    }
    if (std::isfinite(task.hold_s)) work.takes_s += task.hold_s;
  }
  if (!is_laid) lay();
  return work;
}

}  // namespace

Resurvey resurvey_of(const Scenario& scenario, std::span<const Structure> structures,
                     std::span<const Inspected> inspected) {
  Resurvey out;
  std::vector<ScenarioVehicle> vehicles;
  double takes_s = 0;
  for (const Inspected& one : inspected) {
    const ScenarioVehicle& entry = scenario.vehicles.at(one.vehicle);
    const double clear_m = entry.conduct ? 0.5 * entry.conduct->clear_m : 0.5;
    const ResurveyWay way =
        resurvey_way(one.inspection, one.state, structures, one.is_in_water, clear_m);
    if (way.stands.empty()) continue;
    const NewWork work = work_again(entry, way, structures);
    ScenarioVehicle& again = vehicles.emplace_back(entry);
    again.tasks = work.tasks;
    again.carrier.reset();
    takes_s = std::max(takes_s, work.takes_s);
    out.words.push_back(entry.name +
                        formatted(": {:.0f} m2 are not covered, {:.0f} of them seen too poorly; "
                                  "another look from {} places takes about {:.0f} min{}",
                                  way.left_m2, way.poorly_m2, way.stands.size(), work.takes_s / 60,
                                  way.asks_slower ? ", at half the speed" : ""));
  }
  if (vehicles.empty()) return out;
  Scenario& again = out.scenario.emplace(scenario);
  again.name += ", flown again";
  again.duration_s = 60 * std::ceil(std::max(scenario.duration_s, spare * takes_s) / 60);
  again.vehicles = std::move(vehicles);
  again.yaml = write_scenario(again);
  return out;
}

}  // namespace slackwater::twin
