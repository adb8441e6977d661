#include "twin/scenario/expand_mission.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/mission/conduct.h"
#include "twin/mission/reach.h"
#include "twin/scenario/laid_out_task.h"
#include "twin/scenario/lay_out_agent.h"
#include "twin/scenario/read_scenario.h"
#include "twin/scenario/tenders.h"
#include "twin/scenario/write_scenario.h"

namespace slackwater::twin {
namespace {

std::vector<const WorkTurbine*> turbines_of(const Config& mission, const WorkSite& site) {
  std::vector<const WorkTurbine*> chosen;
  std::vector<std::string> known;
  for (const WorkTurbine& turbine : site.turbines) known.push_back(turbine.id);
  for (const std::string& id : mission.texts("turbines")) {
    const auto found = std::find_if(site.turbines.begin(), site.turbines.end(),
                                    [&](const WorkTurbine& t) { return t.id == id; });
    if (found == site.turbines.end())
      mission.refuse("turbines", "found " + id + ", the site has " +
                                     (known.empty() ? "no turbines" : joined(known, ", ")));
    chosen.push_back(&*found);
  }
  if (chosen.empty())
    mission.refuse("turbines", "missing; name at least one of " +
                                   (known.empty() ? "a site that has some" : joined(known, ", ")));
  return chosen;
}

std::vector<ScenarioStructure> structures_of(const WorkSite& site) {
  std::vector<ScenarioStructure> all;
  for (const WorkTurbine& t : site.turbines) {
    ScenarioStructure& s = all.emplace_back();
    s.name = t.id;
    s.centre_m = {to_micrometre(t.north_m), to_micrometre(t.east_m), 0};
    s.diameter_m = to_micrometre(2 * t.radius_m);
    s.top_m = -to_micrometre(-std::min(t.hub_m, t.top_m));
    s.bottom_m = to_micrometre(t.foot_m);
    s.size_m.z = s.bottom_m - s.top_m;
    s.turns_current = !t.floats();
  }
  return all;
}

/// Waves of a forecast err in each member, unless the caller or the mission says otherwise.
bool have_height_errors(const Config& mission, const ScenarioWaves& waves,
                        std::optional<bool> wanted) {
  if (!waves.from_forecast) return false;
  const auto own = mission.optional_child("waves");
  const auto said = own ? own->optional_flag("height_errors") : std::nullopt;
  return wanted.value_or(said.value_or(true));
}

/// The mission's own and those of the caller, which go first.
std::vector<Assumption> assumed_by(const Config& mission, const std::vector<Assumption>& given) {
  std::vector<Assumption> all = given;
  for (const Assumption& own : read_assumptions(mission)) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const Assumption& other) {
      return other.variable == own.variable;
    });
    if (!is_given) all.push_back(own);
  }
  for (Assumption& assumption : all) assumption.value = to_micrometre(assumption.value);
  return all;
}

bool is_in(Range range, double value) { return value >= range.low && value <= range.high; }

bool is_within_reach(const Triple<double>& at_m) {
  return is_in(within_reach_m, at_m.x) && is_in(within_reach_m, at_m.y) &&
         at_m.z >= -reached_height_m.high && at_m.z <= reached_depth_m.high;
}

/// What a scenario's reader refuses of numbers, which here come of a site and of work at it.
void expect_within_reach(const Scenario& scenario) {
  const auto expect_near = [](bool is_near, const std::string& what) {
    if (!is_near)
      refuse(
          formatted("{} too far away; expected it within {:.0f} km north and east of the run's "
                    "origin, and from {:.0f} m above to {:.0f} m below the sea",
                    what, farthest_m / 1000, reached_height_m.high, reached_depth_m.high));
  };
  for (const ScenarioStructure& s : scenario.structures) {
    expect_near(is_within_reach(s.centre_m), "turbine " + s.name + " stands");
    if (!is_in(cylinder_diameter_m, s.diameter_m))
      refuse(
          formatted("turbine {}: found a foundation {:g} m wide, expected {:g} to {:g} m; state "
                    "its foundation in the site's file",
                    s.name, s.diameter_m, cylinder_diameter_m.low, cylinder_diameter_m.high));
    if (!is_in(structure_height_m, -s.top_m) || !(s.bottom_m > s.top_m) ||
        s.bottom_m > reached_depth_m.high)
      refuse(
          formatted("turbine {}: found its top at {:g} m and its foot at {:g} m above the sea; "
                    "expected the foot below the top, {:g} m high and {:g} m deep at most",
                    s.name, -s.top_m, -s.bottom_m, structure_height_m.high, reached_depth_m.high));
  }
  for (const ScenarioVehicle& vehicle : scenario.vehicles) {
    expect_near(is_within_reach(vehicle.start_m), vehicle.name + " starts");
    expect_near(
        !vehicle.tether || !vehicle.tether->top_m || is_within_reach(*vehicle.tether->top_m),
        "the tether of " + vehicle.name + " is fixed");
    for (const ScenarioTask& task : vehicle.tasks) {
      for (const Waypoint& at : task.waypoints)
        expect_near(is_within_reach(at.position_m), vehicle.name + " has work");
      if (task.waypoints.size() > most_waypoints)
        refuse(
            formatted("{}: found {} waypoints in one task, expected at most {}; take a coarser "
                      "pattern",
                      vehicle.name, task.waypoints.size(), most_waypoints));
    }
  }
}

bool is_thinned(const std::optional<Config>& over, const Intensity& thinned_by) {
  const auto said = over ? over->optional_child("intensity") : std::nullopt;
  return thinned(said ? read_intensity(*said) : Intensity{}, thinned_by).density < 1;
}

}  // namespace

ExpandedMission expand_mission(const Config& mission, const MissionParts& parts) {
  ExpandedMission out;
  if (mission.has("site")) (void)mission.text("site");
  const std::vector<const WorkTurbine*> turbines = turbines_of(mission, parts.site);
  for (const WorkTurbine* turbine : turbines) {
    out.turbines.push_back(turbine->id);
    out.water_depth_m = std::max(out.water_depth_m, turbine->bed_m);
  }
  std::optional<ForecastWater> of_the_site;
  if (!parts.site_id.empty()) of_the_site = ForecastWater{parts.site_id, {}, "", false};
  Scenario& scenario = out.scenario;
  scenario = read_setting(mission, of_the_site);
  scenario.waves.have_height_errors =
      have_height_errors(mission, scenario.waves, parts.height_errors);
  if (!mission.has("origin") && parts.origin) {
    scenario.origin = GeoPoint::from_degrees(to_micrometre(parts.origin->latitude_deg()),
                                             to_micrometre(parts.origin->longitude_deg()));
    scenario.has_origin = true;
  }
  const std::vector<Assumption> assumed = assumed_by(mission, parts.assumed);
  scenario.structures = structures_of(parts.site);
  const bool by_sensors = read_navigation(mission, false);
  const auto overs = mission.optional_child("agents");
  std::set<std::string> names;
  Tenders tenders(mission, parts.site, turbines);
  const std::vector<std::string> tasks = mission.texts("tasks");
  if (tasks.empty()) mission.refuse("tasks", "missing; name at least one of data/tasks");
  for (const std::string& id : tasks) {
    const Config task = parts.task(id);
    out.tasks.push_back(task.text("name"));
    for (const char* about :
         {"id", "category", "sources", "demonstrated", "duration_h", "min_window_h", "daylight",
          "splittable", "least_visit_h", "status", "autonomy", "sensors", "notes", "risks"})
      if (task.has(about)) (void)task.value(about);
    const std::vector<Config> agents = task.children("agents");
    if (agents.empty()) task.refuse("agents", "missing; a task has at least one agent");
    for (const Config& agent : agents) {
      const std::string role = agent.text("role");
      if (!names.insert(role).second)
        mission.refuse("tasks", "two tasks have an agent called " + role +
                                    "; fly them one after the other, or rename a role");
      out.requirements.push_back({role, agent.texts("kinds"), agent.texts("needs")});
      const auto over = overs ? overs->optional_child(role) : std::nullopt;
      const std::vector<Triple<double>>& stands_m = tenders.taken_by(role, agent, over);
      scenario.vehicles.push_back(
          lay_out_agent(role, agent, over, parts, turbines, stands_m, assumed, by_sensors));
      out.workers.push_back(role);
      out.is_thinned |= is_thinned(over, parts.thinned_by);
    }
    task.expect_all_read();
  }
  for (ScenarioVehicle& vehicle : tenders.vehicles(by_sensors))
    scenario.vehicles.push_back(std::move(vehicle));
  for (ScenarioVehicle& vehicle : scenario.vehicles) vehicle.logs_sensors = scenario.logs_sensors;
  if (overs) overs->expect_all_read();
  if (const auto fault = fault_of(scenario))
    mission.refuse(
        fault->vehicle ? "vehicles" : fault->key,
        (fault->vehicle ? scenario.vehicles[*fault->vehicle].name + ": " + fault->key + ": "
                        : std::string()) +
            fault->why);
  expect_within_reach(scenario);
  scenario.yaml = write_scenario(scenario);
  return out;
}

}  // namespace slackwater::twin
