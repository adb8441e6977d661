#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "fields/wave/scenario_sea.h"
#include "twin/clearance/read_stand_off.h"
#include "twin/control/patterns.h"
#include "twin/mission/reach.h"
#include "twin/mission/read_seconds.h"
#include "twin/scenario/read_scenario.h"

namespace slackwater::twin {
namespace {

using constants::degree;
constexpr Range speed{0.01, 60};

/// Depth down or height up, exactly one of them.
double read_down(const Config& config) {
  const auto deep = config.optional_number("depth_m", reached_depth_m);
  const auto high = config.optional_number("height_m", reached_height_m);
  if (deep && high) config.refuse("height_m", "found beside depth_m; give one of the two");
  if (!deep && !high)
    config.refuse("depth_m", "missing; give depth_m below mean sea level, or height_m above it");
  return deep ? *deep : -*high;
}

Triple<double> read_place(const Config& config) {
  return {config.number("north_m", within_reach_m), config.number("east_m", within_reach_m),
          read_down(config)};
}

struct AskedSpeed {
  double m_s = 0;  ///< 0: none
  bool is_over_ground = false;
};

/// `speed_m_s`, through the water for craft that swim or float, or `ground_speed_m_s`.
AskedSpeed read_speed(const Config& config) {
  const auto own = config.optional_number("speed_m_s", speed);
  const auto over_ground = config.optional_number("ground_speed_m_s", speed);
  if (own && over_ground)
    config.refuse("ground_speed_m_s",
                  "found beside speed_m_s, which AUVs and surface craft keep through the water; "
                  "give one of the two");
  return over_ground ? AskedSpeed{*over_ground, true} : AskedSpeed{own.value_or(0), false};
}

void put_speed(const AskedSpeed& asked, Waypoint& waypoint) {
  waypoint.speed_m_s = asked.m_s;
  waypoint.over_ground = asked.is_over_ground ? 1 : 0;
}

std::vector<Waypoint> read_waypoints(const Config& config) {
  std::vector<Waypoint> out;
  for (const Config& at : config.children("waypoints")) {
    Waypoint waypoint;
    waypoint.position_m = read_place(at);
    put_speed(read_speed(at), waypoint);
    out.push_back(waypoint);
  }
  if (out.empty() || out.size() > most_waypoints)
    config.refuse("waypoints", "found " + std::to_string(out.size()) +
                                   " waypoints, expected 1 to " + std::to_string(most_waypoints));
  return out;
}

/// `battery` of a time on board: keep, swap, or charge with `charger_w`.
double read_charger(const Config& config) {
  const std::string word = config.optional_text("battery").value_or("keep");
  if (word == "charge") return config.number("charger_w", {0.1, 1e6});
  if (word == "swap") return std::numeric_limits<double>::infinity();
  if (word != "keep") config.refuse("battery", "found " + word + ", expected keep, swap or charge");
  return 0;
}

/// `until` of a time on board: stand_by, or none.
bool read_until(const Config& config) {
  const auto word = config.optional_text("until");
  if (word && *word != "stand_by") config.refuse("until", "found " + *word + ", expected stand_by");
  return word.has_value();
}

ScenarioTask read_task(const Config& config) {
  const std::string kind = config.text("do");
  const auto course = [&] { return config.number("course_deg", {-360, 360}) * degree; };
  ScenarioTask task;
  if (kind == "route") {
    task.waypoints = read_waypoints(config);
  } else if (kind == "hold") {
    task.kind = ScenarioTask::Kind::hold;
    task.hold_s = has_seconds(config, "duration")
                      ? read_seconds(config, "duration", {0, 30 * 86400.0})
                      : std::numeric_limits<double>::infinity();
  } else if (kind == "lawn_mower") {
    task.waypoints = lawn_mower(
        read_place(config.child("corner")), course(), config.number("length_m", {1, farthest_m}),
        config.number("spacing_m", {0.1, farthest_m}), config.integer("lines", 1, 1000), 0);
  } else if (kind == "orbit") {
    const Config centre = config.child("centre");
    const Triple<double> at = read_place(centre);
    const double radius_m = config.number("radius_m", {0.5, 5000});
    task.waypoints =
        orbit(at, radius_m, config.optional_number("from_deg", {-360, 360}).value_or(0) * degree,
              config.number("turns", {0.1, 1000}),
              config.optional_number("end_depth_m", {-1000, 12000}).value_or(at.z),
              config.optional_number("chord_m", {0.1, 1000}).value_or(0.5 * radius_m), 0);
  } else if (kind == "depth_sweep") {
    task.waypoints = depth_sweep(
        read_place(config.child("from")), course(), config.number("length_m", {1, farthest_m}),
        config.number("shallow_m", reached_depth_m), config.number("deep_m", reached_depth_m),
        config.number("wavelength_m", {1, farthest_m}),
        config.optional_number("spacing_m", {0.1, 1000}).value_or(2), 0);
  } else if (kind == "aboard") {
    task.kind = ScenarioTask::Kind::aboard;
    task.until_stand_by = read_until(config);
    if (!task.until_stand_by || has_seconds(config, "duration"))
      task.hold_s = read_seconds(config, "duration", {0, 30 * 86400.0});
    task.charger_w = read_charger(config);
  } else if (kind == "stand_by") {
    task.kind = ScenarioTask::Kind::stand_by;
    task.hold_s = std::numeric_limits<double>::infinity();
  } else if (kind == "follow_track") {
    task.kind = ScenarioTask::Kind::follow_track;
    task.follow = read_track_to_follow(config);
  } else if (kind == "actuators") {
    task.kind = ScenarioTask::Kind::actuators;
    task.hold_s = read_seconds(config, "duration", {0.001, 30 * 86400.0});
    task.table = read_actuator_table(config, task.hold_s);
  } else if (const auto manoeuvre = manoeuvre_named(kind)) {
    task.kind = ScenarioTask::Kind::manoeuvre;
    task.manoeuvre = read_manoeuvre(config, *manoeuvre);
    task.hold_s = longest_s(*task.manoeuvre);
  } else {
    config.refuse("do", "found " + kind +
                            ", expected route, hold, lawn_mower, orbit, depth_sweep, "
                            "follow_track, aboard, stand_by, actuators, steps, turning_circle, "
                            "zig_zag, spiral or pull_out");
  }
  if (const auto word = config.optional_text("phase")) {
    const auto phase = phase_of(*word);
    if (!phase)
      config.refuse("phase",
                    "found " + *word + ", expected transit, launch, work, recovery or return");
    task.phase = *phase;
  }
  if (const auto frame = config.optional_text("frame")) {
    if (*frame != "fixed" && *frame != "drifting")
      config.refuse("frame", "found " + *frame + ", expected fixed or drifting");
    if (task.waypoints.empty())
      config.refuse("frame", "found at a task without waypoints, which have a frame; leave it out");
    task.drifts = *frame == "drifting";
  }
  if (!task.waypoints.empty()) {
    const AskedSpeed asked = read_speed(config);
    for (Waypoint& waypoint : task.waypoints)
      if (!(waypoint.speed_m_s > 0)) put_speed(asked, waypoint);
  }
  return task;
}

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

ForecastWater read_forecast(const Config& config) {
  ForecastWater water;
  water.site = config.optional_text("site").value_or("");
  water.file = config.optional_text("file").value_or("");
  if (water.site.empty() == water.file.empty())
    config.refuse("site", "give the site of a forecast in the store, or the file of one");
  water.accept_means = config.optional_flag("accept_means").value_or(false);
  if (const auto day = config.optional_text("day")) {
    try {
      water.day = parse_day(*day);
    } catch (const Error& problem) {
      config.refuse("day", problem.message());
    }
  }
  return water;
}

MadeUpWater read_made_up(const Config& config) {
  MadeUpWater water;
  water.depth_m = config.number("depth_m", {1, 12000});
  double above_m = -1;
  for (const Config& level : config.children("current")) {
    MadeUpLevel at{level.number("depth_m", {0, water.depth_m}), level.number("east_m_s", {-10, 10}),
                   level.number("north_m_s", {-10, 10})};
    if (at.depth_m <= above_m)
      level.refuse("depth_m", "not below the level before it; list levels from the surface down");
    above_m = at.depth_m;
    water.current.push_back(at);
  }
  if (const auto wind = config.optional_child("wind")) {
    water.wind_speed_m_s = wind->number("speed_m_s", {0, 75});
    water.wind_from_deg = wind->number("from_deg", {-360, 360});
  }
  return water;
}

/// @param depth_m  of the water, where that is known
RegularWave read_regular(const Config& waves, std::optional<double> depth_m) {
  for (const char* const other : {"partitions", "components", "height_errors"})
    if (waves.has(other))
      waves.refuse(other, "found beside regular, which is one wave; leave it out");
  const Config config = waves.child("regular");
  RegularWave wave;
  wave.height_m = config.number("height_m", {0.001, 30});
  wave.period_s = config.number("period_s", {0.5, 30});
  wave.from_direction_deg = config.number("from_deg", {-360, 360});
  if (const std::string why = depth_m ? why_it_breaks(wave, *depth_m) : ""; !why.empty())
    config.refuse("height_m", why);
  return wave;
}

/// @param depth_m  of made-up water
ScenarioWaves read_waves(const Config& config, std::optional<double> depth_m) {
  const bool has_forecast = !depth_m;
  ScenarioWaves waves;
  waves.from_forecast = has_forecast;
  const auto c = config.optional_child("waves");
  if (!c) return waves;
  waves.components =
      static_cast<std::size_t>(c->optional_integer("components", 8, 1024).value_or(200));
  const std::string from =
      c->optional_text("from").value_or(c->is_mapping("regular")   ? "regular"
                                        : c->is_list("partitions") ? "partitions"
                                                                   : "forecast");
  if (from == "regular" || c->has("regular")) {
    if (from != "regular")
      c->refuse("regular", "found beside from: " + from + "; leave one of the two out");
    waves.from_forecast = false;
    waves.regular = read_regular(*c, depth_m);
    return waves;
  }
  waves.have_height_errors = c->optional_flag("height_errors").value_or(false);
  if (from == "forecast") {
    if (!has_forecast)
      c->refuse(
          "from",
          "made-up water has no wave forecast; give partitions, a regular wave, or from: calm");
    return waves;
  }
  if (waves.have_height_errors)
    c->refuse("height_errors", "found true, but the waves are not from a forecast; leave it out");
  waves.from_forecast = false;
  if (from == "calm") return waves;
  if (from != "partitions")
    c->refuse("from", "found " + from + ", expected forecast, calm, partitions or regular");
  std::vector<WavePartition> partitions;
  for (const Config& p : c->children("partitions")) {
    WavePartition partition;
    partition.significant_height_m = p.number("significant_height_m", {0, 30});
    partition.peak_period_s = p.number("peak_period_s", {0.5, 30});
    partition.from_direction_deg = p.number("from_deg", {-360, 360});
    partition.gamma = p.optional_number("gamma", {1, 10});
    if (const auto s = p.optional_number("spreading_s", {0, 1000})) partition.spreading_s = *s;
    partitions.push_back(partition);
  }
  waves.made_up = scenario_sea(partitions, c->name() + ": waves");
  return waves;
}

ScenarioStructure read_structure(const Config& config) {
  ScenarioStructure s;
  s.name = config.optional_text("name").value_or("structure");
  s.centre_m = {config.number("north_m", within_reach_m), config.number("east_m", within_reach_m),
                0};
  const std::string kind = config.text("kind");
  if (kind == "cylinder") {
    s.diameter_m = config.number("diameter_m", cylinder_diameter_m);
    s.turns_current = config.optional_flag("turns_current").value_or(false);
  } else if (kind == "box") {
    s.kind = ScenarioStructure::Kind::box;
    s.size_m.x = config.number("north_size_m", {0.1, 500});
    s.size_m.y = config.number("east_size_m", {0.1, 500});
  } else {
    config.refuse("kind", "found " + kind + ", expected cylinder or box");
  }
  s.top_m = -config.number("top_height_m", structure_height_m);
  s.bottom_m = config.number("bottom_depth_m", {-500, 12000});
  if (!(s.bottom_m > s.top_m)) config.refuse("bottom_depth_m", "is above the top of the structure");
  s.size_m.z = s.bottom_m - s.top_m;
  return s;
}

std::variant<ForecastWater, MadeUpWater> read_water(const Config& config) {
  const Config water = config.child("water");
  const auto forecast = water.optional_child("forecast");
  const auto made_up = water.optional_child("made_up");
  if (forecast.has_value() == made_up.has_value())
    config.refuse("water", "give one of forecast and made_up");
  if (forecast) return read_forecast(*forecast);
  return read_made_up(*made_up);
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
