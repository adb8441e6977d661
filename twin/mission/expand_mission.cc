#include "twin/mission/expand_mission.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/mission/conduct.h"
#include "twin/mission/read_seconds.h"
#include "twin/mission/way_round.h"
#include "twin/mission/work_pattern.h"

namespace slackwater::twin {
namespace {

constexpr double degree = constants::pi / 180;

/// To the micrometre.
std::string number_text(double value) {
  return formatted("{:.12g}", std::round(value * 1e6) / 1e6 + 0.0);
}

std::string place_text(const Triple<double>& at_m) {
  return "north_m: " + number_text(at_m.x) + ", east_m: " + number_text(at_m.y) +
         (at_m.z < 0 ? ", height_m: " + number_text(-at_m.z)
                     : ", depth_m: " + number_text(std::max(at_m.z, 0.0)));
}

std::string route_text(std::span<const Waypoint> waypoints, Phase phase) {
  std::string text = "      - {do: route, phase: " + std::string(name_of(phase)) + ", waypoints: [";
  bool is_first = true;
  for (const Waypoint& at : waypoints) {
    text += (is_first ? "{" : ", {") + place_text(at.position_m);
    if (at.speed_m_s > 0) text += ", speed_m_s: " + number_text(at.speed_m_s);
    text += "}";
    is_first = false;
  }
  return text + "]}\n";
}

std::string hold_text(double duration_s, Phase phase) {
  return "      - {do: hold, phase: " + std::string(name_of(phase)) +
         ", duration_s: " + number_text(duration_s) + "}\n";
}

std::string aboard_text(double duration_s, bool is_swapped, Phase phase) {
  return "      - {do: aboard, phase: " + std::string(name_of(phase)) +
         ", duration_s: " + number_text(duration_s) + (is_swapped ? ", battery: swap" : "") + "}\n";
}

std::vector<Structure> structures_of(const WorkSite& site) {
  std::vector<Structure> all;
  for (const WorkTurbine& t : site.turbines)
    all.push_back(Cylinder{t.north_m, t.east_m, t.radius_m, std::min(t.hub_m, t.top_m), t.foot_m});
  return all;
}

/// Keys of a mapping with what stands in another put in their place, as YAML on one line.
std::string merged(const std::optional<Config>& base, const std::optional<Config>& over,
                   const std::set<std::string>& left_out = {}) {
  std::vector<std::pair<std::string, std::string>> entries;
  const auto put = [&](const Config& from) {
    for (const std::string& key : from.keys()) {
      if (left_out.contains(key)) continue;
      const auto same = std::find_if(entries.begin(), entries.end(),
                                     [&](const auto& entry) { return entry.first == key; });
      if (same == entries.end())
        entries.emplace_back(key, from.flow_yaml(key));
      else
        same->second = from.flow_yaml(key);
    }
  };
  if (base) put(*base);
  if (over) put(*over);
  std::string text = "{";
  for (const auto& [key, value] : entries)
    text += (text.size() > 1 ? ", " : "") + key + ": " + value;
  return text + "}";
}

/// What of an agent's entry in a mission is not of its conduct.
const std::set<std::string> of_the_vehicle{"model", "state_of_charge", "navigation", "speed_m_s",
                                           "start"};

/// One agent of a task, made into a vehicle of the scenario.
class AgentWriter {
 public:
  AgentWriter(const Config& agent, const std::optional<Config>& over, const MissionParts& parts,
              std::span<const WorkTurbine* const> turbines)
      : agent_(agent),
        over_(over),
        parts_(parts),
        turbines_(turbines),
        structures_(structures_of(parts.site)) {}

  /// @param assumed  as YAML on one line; empty: nothing is
  std::string write(const std::string& name, const std::string& assumed) {
    home_m_ = read_start();
    is_at_m_ = home_m_;
    clear_m_ = agent_.optional_number("clear_m", {0.2, 500}).value_or(2);
    has_tether_ = agent_.has("tether");
    const std::string tasks = write_tasks();
    std::string text = "  - name: " + name + "\n    model: " + model() + "\n    start: {" +
                       place_text(home_m_) +
                       ", heading_deg: " + number_text(bearing_to_turbine() / degree) + "}\n";
    for (const char* key : {"speed_m_s", "state_of_charge", "navigation"})
      if (const auto value = chosen(key)) text += "    " + std::string(key) + ": " + *value + "\n";
    if (has_tether_) text += write_tether();
    text += "    conduct: " + write_conduct(assumed) + "\n    tasks:\n" + tasks;
    return text;
  }

 private:
  std::optional<std::string> chosen(const char* key) const {
    const auto of_task = agent_.optional_text(key);
    return over_ && over_->has(key) ? over_->text(key) : of_task;
  }
  std::string model() const { return chosen("model").value_or(agent_.text("model")); }

  double bearing_to_turbine() const {
    const WorkTurbine& first = *turbines_.front();
    return std::atan2(first.east_m - home_m_.y, first.north_m - home_m_.x);
  }

  Triple<double> place_at(const Config& place, const WorkTurbine& turbine) const {
    const auto bearing = place.optional_number("bearing_deg", {-360, 360});
    return turbine.around(bearing ? *bearing * degree : turbine.landing_rad,
                          turbine.radius_m + place.number("distance_m", {0.2, 20e3}),
                          read_level(place, turbine));
  }
  Triple<double> read_start() const { return place_at(agent_.child("start"), *turbines_.front()); }

  std::string write_tether() const {
    const Config tether = agent_.child("tether");
    const Triple<double> top_m = place_at(tether.child("top"), *turbines_.front());
    return "    tether: {top: {" + place_text(top_m) +
           "}, length_m: " + number_text(tether.number("length_m", {10, 10000})) + "}\n";
  }

  std::string write_conduct(const std::string& assumed) const {
    const auto base = agent_.optional_child("conduct");
    // Said wrong in the task, it is refused where it stands.
    if (base) {
      (void)read_conduct(*base);
      base->expect_all_read();
    }
    const std::string conduct = merged(base, over_, of_the_vehicle);
    std::string text = conduct.substr(0, conduct.size() - 1) + (conduct.size() > 2 ? ", " : "");
    if (conduct.find("home: ") == std::string::npos)
      text += "home: {" + place_text(home_m_) + "}, ";
    if (conduct.find("clear_m: ") == std::string::npos)
      text += "clear_m: " + number_text(clear_m_) + ", ";
    if (!assumed.empty()) text += "assume: " + assumed + ", ";
    return text.substr(0, text.size() - 2) + "}";
  }

  void go_to(const Triple<double>& to_m, Phase phase, std::string& text) {
    if (length_of(to_m - is_at_m_) < 0.1) return;
    text += route_text(way_round(is_at_m_, to_m, near(is_at_m_, to_m), clear_m_), phase);
    is_at_m_ = to_m;
  }

  /// What stands by the way; the rest would only cost.
  std::vector<Structure> near(const Triple<double>& from_m, const Triple<double>& to_m) const {
    std::vector<Structure> some;
    for (const Structure& structure : structures_)
      if (least_distance_m(structure, from_m, to_m) < 2 * clear_m_) some.push_back(structure);
    return some;
  }

  std::string write_tasks() {
    const bool stands_aboard = agent_.has("swap") || agent_.has("swap_s");
    const double swap_s = stands_aboard ? read_seconds(agent_, "swap", {1, 86400}) : 0;
    const double launch_s =
        has_seconds(agent_, "launch") ? read_seconds(agent_, "launch", {0, 86400}) : 0;
    const double recovery_s =
        has_seconds(agent_, "recovery") ? read_seconds(agent_, "recovery", {0, 86400}) : 0;
    std::string text;
    if (stands_aboard)
      text += aboard_text(launch_s, false, Phase::launch);
    else if (launch_s > 0)
      text += hold_text(launch_s, Phase::launch);
    std::vector<Config> works = agent_.children("work");
    if (works.empty())
      agent_.refuse("work", "missing; a task has work, each entry a pattern (work_pattern.h)");
    bool is_first = true;
    for (const WorkTurbine* turbine : turbines_) {
      for (const Config& work : works) {
        if (!is_first && stands_aboard) {
          go_to(home_m_, Phase::return_home, text);
          text += aboard_text(swap_s, true, Phase::recovery);
        }
        is_first = false;
        write_work(lay_out(work, parts_.site, *turbine), text);
      }
    }
    go_to(home_m_, Phase::return_home, text);
    if (stands_aboard)
      text += aboard_text(recovery_s, false, Phase::recovery);
    else if (recovery_s > 0)
      text += hold_text(recovery_s, Phase::recovery);
    return text;
  }

  void write_work(const std::vector<WorkLeg>& legs, std::string& text) {
    bool is_first = true;
    for (const WorkLeg& leg : legs) {
      if (is_first) go_to(leg.waypoints.front().position_m, Phase::transit, text);
      is_first = false;
      text += route_text(clear_of_piles(leg.waypoints), Phase::work);
      is_at_m_ = leg.waypoints.back().position_m;
      if (leg.stay_s > 0) text += hold_text(leg.stay_s, Phase::work);
    }
  }

  /// Legs that would lead through something that stands there go round it.
  std::vector<Waypoint> clear_of_piles(const std::vector<Waypoint>& leg) const {
    std::vector<Waypoint> way;
    for (const Waypoint& at : leg) {
      std::vector<Structure> crossed;
      if (!way.empty())
        for (const Structure& structure : structures_)
          if (least_distance_m(structure, way.back().position_m, at.position_m) < 0)
            crossed.push_back(structure);
      if (crossed.empty()) {
        way.push_back(at);
        continue;
      }
      const Triple<double> from_m = way.back().position_m;
      for (const Waypoint& round :
           way_round(from_m, at.position_m, crossed, clear_m_, at.speed_m_s))
        way.push_back(round);
    }
    return way;
  }

  const Config& agent_;
  const std::optional<Config>& over_;
  const MissionParts& parts_;
  std::span<const WorkTurbine* const> turbines_;
  std::vector<Structure> structures_;
  Triple<double> home_m_;
  Triple<double> is_at_m_;
  double clear_m_ = 2;
  bool has_tether_ = false;
};

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
    text += "  - {name: " + t.id + ", kind: cylinder, north_m: " + number_text(t.north_m) +
            ", east_m: " + number_text(t.east_m) + ", diameter_m: " + number_text(2 * t.radius_m) +
            ", top_height_m: " + number_text(-std::min(t.hub_m, t.top_m)) +
            ", bottom_depth_m: " + number_text(t.foot_m) +
            (t.floats() ? "" : ", turns_current: true") + "}\n";
  }
  return text;
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
  for (const char* key :
       {"seed", "start", "duration", "step_s", "log_every_s", "origin", "water", "member", "waves",
        "gusts", "wakes", "navigation", "log", "traffic", "clearance"})
    if (mission.has(key)) text += std::string(key) + ": " + mission.flow_yaml(key) + "\n";
  if (!mission.has("origin") && parts.origin)
    text += "origin: {latitude_deg: " + number_text(parts.origin->latitude_deg()) +
            ", longitude_deg: " + number_text(parts.origin->longitude_deg()) + "}\n";
  if (!mission.has("water") && !parts.site_id.empty())
    text += "water: {forecast: {site: " + parts.site_id + "}}\n";
  const std::string assumed = assumed_text(mission, parts.assumed);
  text += structures_text(parts.site);
  text += "vehicles:\n";
  const auto overs = mission.optional_child("agents");
  std::set<std::string> names;
  const std::vector<std::string> tasks = mission.texts("tasks");
  if (tasks.empty()) mission.refuse("tasks", "missing; name at least one of data/tasks");
  for (const std::string& id : tasks) {
    const Config task = parts.task(id);
    out.tasks.push_back(task.text("name"));
    for (const char* about : {"id", "category", "sources", "demonstrated", "duration_h",
                              "min_window_h", "status", "autonomy", "sensors", "notes"})
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
      text += AgentWriter(agent, over, parts, turbines).write(role, assumed);
      out.workers.push_back(role);
    }
    task.expect_all_read();
  }
  for (const Config& vehicle : mission.children("vehicles")) {
    (void)vehicle.keys();
    text += "  - " + merged(vehicle, std::nullopt) + "\n";
  }
  if (overs) overs->expect_all_read();
  return out;
}

}  // namespace slackwater::twin
