#include "twin/mission/expand_mission.h"

#include <algorithm>
#include <optional>
#include <set>

#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/mission/agent_text.h"
#include "twin/mission/conduct.h"
#include "twin/mission/scenario_text.h"
#include "twin/mission/tenders.h"

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

std::string structures_text(const WorkSite& site) {
  if (site.turbines.empty()) return "";
  std::string text = "structures:\n";
  for (const WorkTurbine& t : site.turbines) {
    text += "  - {name: " + quoted_yaml(t.id) +
            ", kind: cylinder, north_m: " + number_text(t.north_m) +
            ", east_m: " + number_text(t.east_m) + ", diameter_m: " + number_text(2 * t.radius_m) +
            ", top_height_m: " + number_text(-std::min(t.hub_m, t.top_m)) +
            ", bottom_depth_m: " + number_text(t.foot_m) +
            (t.floats() ? "" : ", turns_current: true") + "}\n";
  }
  return text;
}

/// Those of a forecast err in each member, unless the caller or the mission says otherwise.
std::string waves_text(const Config& mission, std::optional<bool> wanted) {
  const auto own = mission.optional_child("waves");
  const std::vector<std::string> keys = own ? own->keys() : std::vector<std::string>();
  const auto water = mission.optional_child("water");
  const std::vector<std::string> waters = water ? water->keys() : std::vector<std::string>();
  const bool is_made_up = std::find(waters.begin(), waters.end(), "made_up") != waters.end();
  const bool is_stated = own && (own->is_list("partitions") ||
                                 own->optional_text("from").value_or("forecast") != "forecast");
  if (is_made_up || is_stated) return own ? "waves: " + mission.flow_yaml("waves") + "\n" : "";
  bool errs = true;
  std::string text;
  for (const std::string& key : keys) {
    if (key == "height_errors")
      errs = own->optional_flag(key).value_or(errs);
    else
      text += key + ": " + own->flow_yaml(key) + ", ";
  }
  return "waves: {" + text + "height_errors: " + (wanted.value_or(errs) ? "true" : "false") + "}\n";
}

/// The mission's own and those of the caller, which go first.
std::string assumed_text(const Config& mission, const std::vector<Assumption>& given) {
  std::vector<Assumption> all = given;
  for (const Assumption& own : read_assumptions(mission)) {
    const bool is_given = std::any_of(given.begin(), given.end(), [&](const Assumption& other) {
      return other.variable == own.variable;
    });
    if (!is_given) all.push_back(own);
  }
  std::string text;
  for (const Assumption& assumption : all)
    text += (text.empty() ? "{" : ", ") + std::string(word_of(assumption.variable).key) + ": " +
            number_text(assumption.value);
  return text.empty() ? text : text + "}";
}

}  // namespace

ExpandedMission expand_mission(const Config& mission, const MissionParts& parts) {
  ExpandedMission out;
  if (mission.has("site")) (void)mission.text("site");
  const std::vector<const WorkTurbine*> turbines = turbines_of(mission, parts.site);
  for (const WorkTurbine* turbine : turbines) out.turbines.push_back(turbine->id);
  std::string& text = out.scenario_yaml;
  text = "name: " + mission.flow_yaml("name") + "\n";
  for (const char* key : {"seed", "start", "duration", "step_s", "log_every_s", "origin", "water",
                          "member", "gusts", "wakes", "navigation", "log", "traffic", "clearance"})
    if (mission.has(key)) text += std::string(key) + ": " + mission.flow_yaml(key) + "\n";
  text += waves_text(mission, parts.height_errors);
  if (!mission.has("origin") && parts.origin)
    text += "origin: {latitude_deg: " + number_text(parts.origin->latitude_deg()) +
            ", longitude_deg: " + number_text(parts.origin->longitude_deg()) + "}\n";
  if (!mission.has("water") && !parts.site_id.empty())
    text += "water: {forecast: {site: " + quoted_yaml(parts.site_id) + "}}\n";
  const std::string assumed = assumed_text(mission, parts.assumed);
  text += structures_text(parts.site);
  text += "vehicles:\n";
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
      if (task.has(about)) (void)task.flow_yaml(about);
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
      text += agent_text(role, agent, over, parts, turbines, stands_m, assumed);
      out.workers.push_back(role);
    }
    task.expect_all_read();
  }
  text += tenders.text();
  if (overs) overs->expect_all_read();
  return out;
}

}  // namespace slackwater::twin
