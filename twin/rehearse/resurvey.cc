#include "twin/rehearse/resurvey.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/inspection/resurvey_way.h"
#include "twin/mission/scenario_text.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

constexpr double usual_speed_m_s = 0.3;
constexpr double spare = 1.5;  // of the time that a way takes by reckoning

/// An entry of a block list as one of a flow list.
std::string in_flow(const std::string& entry) {
  const std::size_t from = entry.find("- ") + 2;
  return entry.substr(from, entry.find_last_not_of('\n') + 1 - from);
}

struct NewWork {
  std::vector<std::string> tasks;  ///< YAML on one line each
  double takes_s = 0;
};

/// The vehicle's tasks with its work replaced.
NewWork work_again(const Config& vehicle, const ScenarioVehicle& entry, const ResurveyWay& way,
                   std::span<const Structure> structures) {
  NewWork work;
  const double asked_m_s = entry.speed_m_s.value_or(usual_speed_m_s);
  const double speed_m_s = way.asks_slower ? 0.5 * asked_m_s : asked_m_s;
  const double clear_m = entry.conduct ? entry.conduct->clear_m : 1;
  bool is_written = false;
  Triple<double> at_m = entry.start_m;
  const auto write = [&] {
    for (const ResurveyWay::Stand& stand : way.stands) {
      const auto leg = way_round(at_m, stand.place_m, structures, clear_m, speed_m_s);
      for (const Waypoint& waypoint : leg) {
        work.takes_s += length_of(waypoint.position_m - at_m) / speed_m_s;
        at_m = waypoint.position_m;
      }
      work.tasks.push_back(in_flow(route_text(leg, is_written ? Phase::work : Phase::transit)));
      if (stand.stay_s > 0) work.tasks.push_back(in_flow(hold_text(stand.stay_s, Phase::work)));
      work.takes_s += stand.stay_s;
      is_written = true;
    }
    const auto home = way_round(at_m, entry.start_m, structures, clear_m, asked_m_s);
    work.tasks.push_back(in_flow(route_text(home, Phase::return_home)));
  };
  for (const Config& task : vehicle.children("tasks")) {
    const std::string phase = task.optional_text("phase").value_or("work");
    if (phase == "launch" || phase == "recovery") {
      if (phase == "recovery" && !is_written) write();
      work.tasks.push_back(merged(task, std::nullopt));
    }
    work.takes_s += task.optional_number("duration_s", {}).value_or(0);
  }
  if (!is_written) write();
  return work;
}

}  // namespace

Resurvey resurvey_of(const Scenario& scenario, std::span<const Structure> structures,
                     std::span<const Inspected> inspected) {
  Resurvey out;
  const Config config = Config::parse(scenario.yaml, scenario.name);
  const std::vector<Config> vehicles = config.children("vehicles");
  std::string text;
  double takes_s = 0;
  for (const Inspected& one : inspected) {
    const ScenarioVehicle& entry = scenario.vehicles.at(one.vehicle);
    const double clear_m = entry.conduct ? 0.5 * entry.conduct->clear_m : 0.5;
    const ResurveyWay way =
        resurvey_way(one.inspection, one.state, structures, one.is_in_water, clear_m);
    if (way.stands.empty()) continue;
    const NewWork work = work_again(vehicles.at(one.vehicle), entry, way, structures);
    const std::string kept = merged(vehicles[one.vehicle], std::nullopt, {"tasks", "carrier"});
    text += "  - " + kept.substr(0, kept.size() - 1) + ", tasks: [\n      " +
            joined(work.tasks, ",\n      ") + "]}\n";
    takes_s = std::max(takes_s, work.takes_s);
    out.words.push_back(entry.name +
                        formatted(": {:.0f} m2 are left, {:.0f} of them seen too poorly: from {} "
                                  "places once more, {:.0f} min by reckoning{}",
                                  way.left_m2, way.poorly_m2, way.stands.size(), work.takes_s / 60,
                                  way.asks_slower ? ", at half the speed" : ""));
  }
  if (text.empty()) return out;
  for (const std::string& key : config.keys())
    if (key != "vehicles" && key != "name" && !key.starts_with("duration"))
      out.scenario_yaml += key + ": " + config.flow_yaml(key) + "\n";
  out.scenario_yaml =
      "name: " + quoted_yaml(scenario.name + ", flown again") + "\nduration: " +
      formatted("{:.0f}min", std::ceil(std::max(scenario.duration_s, spare * takes_s) / 60)) +
      "\n" + out.scenario_yaml + "vehicles:\n" + text;
  return out;
}

}  // namespace slackwater::twin
