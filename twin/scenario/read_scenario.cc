#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "twin/clearance/read_stand_off.h"
#include "twin/mission/read_seconds.h"
#include "twin/scenario/read_place.h"
#include "twin/scenario/read_scenario.h"
#include "twin/scenario/read_surroundings.h"
#include "twin/scenario/read_task.h"

namespace slackwater::twin {
namespace {

using constants::degree;

FollowerChoice read_follower(const Config& config) {
  const std::string text = config.optional_text("follow").value_or("line_of_sight");
  if (text == "line_of_sight") return FollowerChoice::line_of_sight;
  if (text == "no_feed_forward") return FollowerChoice::no_feed_forward;
  if (text == "paper") return FollowerChoice::paper;
  if (text == "public") return FollowerChoice::published_code;
  config.refuse("follow",
                "found " + text + ", expected line_of_sight, no_feed_forward, paper or public");
}

/// A top of its own, or the place on its carrier's deck.
ScenarioVehicle::TetherStart read_tether_start(const Config& config, bool has_carrier) {
  ScenarioVehicle::TetherStart tether;
  const auto top = config.optional_child("top");
  if (top && has_carrier)
    config.refuse("top",
                  "found beside a carrier, from whose deck the line hangs; leave one of them out");
  if (!top && !has_carrier)
    config.refuse("top", "missing; give its place, or a carrier from whose deck the line hangs");
  if (top) tether.top_m = read_place(*top);
  tether.length_m = config.number("length_m", {0.1, 10000});
  return tether;
}

/// Vehicles of a run are told apart by their names.
std::optional<ScenarioFault> fault_of_names(const Scenario& scenario) {
  std::set<std::string> names;
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i)
    if (const std::string& name = scenario.vehicles[i].name; !names.insert(name).second)
      return ScenarioFault{i, "name", "found " + name + " twice; name vehicles differently"};
  return std::nullopt;
}

/// What a vehicle does is what it can do.
std::optional<ScenarioFault> fault_of(const ScenarioVehicle& vehicle, std::size_t i) {
  const auto has_task = [&](const auto& counts) {
    return std::any_of(vehicle.tasks.begin(), vehicle.tasks.end(), counts);
  };
  if (has_task([](const auto& t) { return t.drifts; }) &&
      (!vehicle.conduct || !vehicle.conduct->search))
    return ScenarioFault{i, "tasks",
                         "found frame: drifting without a search for a person who drifts; give the "
                         "vehicle's conduct a search, or write frame: fixed"};
  const bool goes_aboard = vehicle.carrier || has_task([](const auto& t) {
                             return t.kind == ScenarioTask::Kind::aboard;
                           });
  if (goes_aboard && !vehicle.conduct)
    return ScenarioFault{i, "conduct",
                         "missing; a vehicle that goes aboard needs a conduct: write conduct: {}"};
  if (!vehicle.conduct &&
      has_task([](const auto& t) { return t.kind == ScenarioTask::Kind::stand_by; }))
    return ScenarioFault{i, "conduct",
                         "missing; a vehicle that stands by needs a conduct: write conduct: {}"};
  if (!vehicle.carrier && has_task([](const auto& t) { return t.until_stand_by; }))
    return ScenarioFault{i, "tasks",
                         "found until: stand_by without a carrier; give the vehicle a carrier, or "
                         "the task a duration"};
  if (vehicle.starts_on_track && (vehicle.tasks.empty() || !vehicle.tasks.front().follow))
    return ScenarioFault{i, "start", "missing; give a place, or a first task that follows a track"};
  return std::nullopt;
}

}  // namespace

StepDetail read_detail(const Config& config) {
  const std::string text = config.optional_text("detail").value_or("full");
  if (text != "full" && text != "coarse")
    config.refuse("detail", "found " + text + ", expected full or coarse");
  return text == "full" ? StepDetail::full : StepDetail::coarse;
}

bool read_navigation(const Config& config, bool otherwise) {
  const auto text = config.optional_text("navigation");
  if (!text) return otherwise;
  if (*text != "truth" && *text != "sensors")
    config.refuse("navigation", "found " + *text + ", expected truth or sensors");
  return *text == "sensors";
}

ScenarioVehicle::Carrier read_carrier(const Config& carrier) {
  constexpr Range on_board{-200, 200};
  return {carrier.text("name"),
          {carrier.number("forward_m", on_board),
           carrier.optional_number("starboard_m", on_board).value_or(0),
           -carrier.optional_number("up_m", on_board).value_or(0)}};
}

ScenarioVehicle read_vehicle(const Config& config, bool by_sensors) {
  ScenarioVehicle vehicle;
  vehicle.name = config.text("name");
  vehicle.model = config.text("model");
  if (const auto start = config.optional_child("start")) {
    vehicle.start_m = read_place(*start);
    vehicle.heading_rad = start->optional_number("heading_deg", {-360, 360}).value_or(0) * degree;
  } else {
    vehicle.starts_on_track = true;
  }
  vehicle.state_of_charge = config.optional_number("state_of_charge", {0, 1}).value_or(1);
  vehicle.held_voltage_v = config.optional_number("hold_bus_v", {1, 1000}).value_or(0);
  vehicle.depth_bound_m = config.optional_number("depth_bound_m", {0, 1000}).value_or(0);
  vehicle.step_s = config.optional_number("step_s", {1e-4, 1});
  if (const AskedSpeed asked = read_speed(config); asked.m_s > 0) {
    vehicle.speed_m_s = asked.m_s;
    vehicle.is_speed_over_ground = asked.is_over_ground;
  }
  vehicle.detail = read_detail(config);
  vehicle.follower = read_follower(config);
  if (const auto tether = config.optional_child("tether"))
    vehicle.tether = read_tether_start(*tether, config.has("carrier"));
  if (const auto carrier = config.optional_child("carrier"))
    vehicle.carrier = read_carrier(*carrier);
  if (const auto conduct = config.optional_child("conduct"))
    vehicle.conduct = read_conduct(*conduct);
  vehicle.keeps_clear = config.optional_flag("keeps_clear").value_or(true);
  for (const Config& task : config.children("tasks")) vehicle.tasks.push_back(read_task(task));
  if (vehicle.tasks.empty()) {
    ScenarioTask hold;
    hold.kind = ScenarioTask::Kind::hold;
    hold.hold_s = std::numeric_limits<double>::infinity();
    vehicle.tasks.push_back(hold);
  }
  vehicle.navigates_by_sensors = read_navigation(config, by_sensors);
  return vehicle;
}

Scenario read_setting(const Config& config, const std::optional<ForecastWater>& otherwise) {
  Scenario s;
  s.name = config.text("name");
  s.seed = static_cast<std::uint64_t>(config.integer("seed", 0, 2147483647));
  if (const auto start = config.optional_text("start")) {
    try {
      s.start = parse_utc(*start);
    } catch (const Error& problem) {
      config.refuse("start", problem.message());
    }
  }
  s.step_s = config.optional_number("step_s", {0.001, 10}).value_or(0.1);
  s.duration_s = read_seconds(config, "duration", {s.step_s, 30 * 86400.0});
  s.log_every_s = config.optional_number("log_every_s", {0.001, 86400}).value_or(1);
  const double steps_per_row = s.log_every_s / s.step_s;
  if (std::abs(steps_per_row - std::round(steps_per_row)) > 1e-6 || steps_per_row < 0.5)
    config.refuse("log_every_s", "is not a whole number of steps of step_s");
  if (config.has("water") || !otherwise)
    s.water = read_water(config);
  else
    s.water = *otherwise;
  const bool is_made_up = std::holds_alternative<MadeUpWater>(s.water);
  s.member = static_cast<std::size_t>(config.optional_integer("member", 0, 100000).value_or(0));
  if (is_made_up && s.member > 0) config.refuse("member", "made-up water has no members");
  if (const auto origin = config.optional_child("origin")) {
    s.origin = GeoPoint::from_degrees(origin->number("latitude_deg", {-90, 90}),
                                      origin->number("longitude_deg", {-360, 360}));
    s.has_origin = true;
  } else if (is_made_up) {
    s.origin = GeoPoint::from_degrees(55, 0);
    s.has_origin = true;
  }
  s.waves = read_waves(
      config, is_made_up ? std::optional(std::get<MadeUpWater>(s.water).depth_m) : std::nullopt);
  const std::string gusts = config.optional_text("gusts").value_or("none");
  if (gusts == "dryden")
    s.gusts = GustModel::dryden;
  else if (gusts != "none")
    config.refuse("gusts", "found " + gusts + ", expected none or dryden");
  s.has_wakes = config.optional_flag("wakes").value_or(false);
  if (const auto log = config.optional_child("log"))
    s.logs_sensors = log->optional_flag("sensors").value_or(false);
  s.traffic = read_traffic(config);
  if (const auto c = config.optional_child("clearance")) s.clearance = read_stand_off(*c);
  return s;
}

std::optional<ScenarioFault> fault_of(const Scenario& scenario) {
  if (scenario.vehicles.empty()) return ScenarioFault{{}, "vehicles", "none; give at least one"};
  for (std::size_t i = 0; i < scenario.vehicles.size(); ++i)
    if (auto fault = fault_of(scenario.vehicles[i], i)) return fault;
  return fault_of_names(scenario);
}

namespace {

Scenario read(const Config& config) {
  if (config.has("tasks"))
    config.refuse("tasks", config.has("turbines")
                               ? "a scenario has none; this is a mission, fly it with `rehearse`"
                               : "a scenario has none of its own; write them below a vehicle");
  Scenario s = read_setting(config, {});
  if (has_seconds(config, "home_after"))
    s.home_after_s = read_seconds(config, "home_after", {0, 86400});
  for (const Config& c : config.children("structures")) s.structures.push_back(read_structure(c));
  const bool by_sensors = read_navigation(config, false);
  const std::vector<Config> vehicles = config.children("vehicles");
  for (const Config& c : vehicles) {
    s.vehicles.push_back(read_vehicle(c, by_sensors));
    s.vehicles.back().logs_sensors = s.logs_sensors;
  }
  if (const auto fault = fault_of(s))
    (fault->vehicle ? vehicles[*fault->vehicle] : config).refuse(fault->key, fault->why);
  config.expect_all_read();
  return s;
}

}  // namespace

Scenario parse_scenario(std::string_view yaml, std::string_view name) {
  Scenario scenario = read(Config::parse(yaml, name));
  scenario.yaml = yaml;
  return scenario;
}

Scenario read_scenario(const std::filesystem::path& file) {
  return parse_scenario(text_of_given_file(file, "the YAML file of a scenario"), file.string());
}

}  // namespace slackwater::twin
