#include "twin/scenario/write_scenario.h"

#include <cmath>

#include "twin/scenario/write_conduct.h"
#include "twin/scenario/write_number.h"

namespace slackwater::twin {
namespace {

YamlValue water_value(const ForecastWater& water) {
  YamlValue forecast;
  if (!water.site.empty()) forecast.put("site", water.site);
  if (!water.file.empty()) forecast.put("file", water.file);
  if (water.day) forecast.put("day", format_day(*water.day));
  if (water.accept_means) forecast.put("accept_means", true);
  return YamlValue().put("forecast", forecast);
}

YamlValue water_value(const MadeUpWater& water) {
  YamlValue made_up;
  made_up.put("depth_m", water.depth_m);
  std::vector<YamlValue> levels;
  for (const MadeUpLevel& level : water.current)
    levels.push_back(YamlValue()
                         .put("depth_m", level.depth_m)
                         .put("east_m_s", level.east_m_s)
                         .put("north_m_s", level.north_m_s));
  if (!levels.empty()) made_up.put("current", std::move(levels));
  made_up.put(
      "wind",
      YamlValue().put("speed_m_s", water.wind_speed_m_s).put("from_deg", water.wind_from_deg));
  return YamlValue().put("made_up", made_up);
}

YamlValue waves_value(const ScenarioWaves& waves) {
  YamlValue value;
  if (waves.regular)
    return value.put("regular", YamlValue()
                                    .put("height_m", waves.regular->height_m)
                                    .put("period_s", waves.regular->period_s)
                                    .put("from_deg", waves.regular->from_direction_deg));
  value.put("components", static_cast<double>(waves.components));
  if (waves.from_forecast) return value.put("height_errors", waves.have_height_errors);
  std::vector<YamlValue> partitions;
  for (const WavePartition& p : waves.made_up.partitions) {
    YamlValue& entry = partitions.emplace_back();
    entry.put("significant_height_m", p.significant_height_m)
        .put("peak_period_s", p.peak_period_s)
        .put("from_deg", p.from_direction_deg)
        .put("spreading_s", p.spreading_s);
    if (p.gamma) entry.put("gamma", *p.gamma);
  }
  if (partitions.empty()) return value.put("from", "calm");
  return value.put("partitions", std::move(partitions));
}

YamlValue structure_value(const ScenarioStructure& s) {
  const bool is_cylinder = s.kind == ScenarioStructure::Kind::cylinder;
  YamlValue value;
  value.put("name", s.name)
      .put("kind", is_cylinder ? "cylinder" : "box")
      .put("north_m", s.centre_m.x)
      .put("east_m", s.centre_m.y);
  if (is_cylinder)
    value.put("diameter_m", s.diameter_m);
  else
    value.put("north_size_m", s.size_m.x).put("east_size_m", s.size_m.y);
  value.put("top_height_m", -s.top_m + 0.0).put("bottom_depth_m", s.bottom_m);
  if (s.turns_current) value.put("turns_current", true);
  return value;
}

void put_speed(double speed_m_s, bool is_over_ground, YamlValue& value) {
  if (speed_m_s > 0) value.put(is_over_ground ? "ground_speed_m_s" : "speed_m_s", speed_m_s);
}

void put_log(const AisLog& log, YamlValue& value) {
  value.put("file", log.file);
  if (log.starts) value.put("starts", format_utc(*log.starts));
}

const char* name_of(ScenarioTask::Kind kind) {
  switch (kind) {
    case ScenarioTask::Kind::route:
      return "route";
    case ScenarioTask::Kind::hold:
      return "hold";
    case ScenarioTask::Kind::follow_track:
      return "follow_track";
    case ScenarioTask::Kind::aboard:
      return "aboard";
    case ScenarioTask::Kind::stand_by:
      return "stand_by";
    case ScenarioTask::Kind::actuators:
      return "actuators";
    case ScenarioTask::Kind::manoeuvre:
      break;
  }
  return "";
}

void put_table(const ActuatorTable& table, YamlValue& value) {
  std::vector<std::string> keep;
  if (table.keeps_depth) keep.emplace_back("depth");
  if (table.keeps_heading) keep.emplace_back("heading");
  if (table.keeps_speed) keep.emplace_back("speed");
  if (!keep.empty()) value.put("keep", YamlValue::words(keep));
  if (table.speed_m_s) value.put("speed_m_s", *table.speed_m_s);
  std::vector<YamlValue> rows;
  for (const ActuatorRow& row : table.rows) {
    YamlValue& entry = rows.emplace_back();
    entry.put("at_s", row.at_s);
    for (const auto& [key, of] : row.setting) entry.put(key, of);
  }
  value.put("table", std::move(rows));
}

YamlValue task_value(const ScenarioTask& task) {
  using Kind = ScenarioTask::Kind;
  YamlValue value;
  const auto put_duration = [&] {
    if (std::isfinite(task.hold_s)) value.put("duration_s", task.hold_s);
  };
  value.put("do", task.manoeuvre ? name_of(task.manoeuvre->kind) : name_of(task.kind))
      .put("phase", name_of(task.phase));
  switch (task.kind) {
    case Kind::route: {
      if (task.drifts) value.put("frame", "drifting");
      std::vector<YamlValue> waypoints;
      for (const Waypoint& at : task.waypoints) {
        YamlValue& entry = waypoints.emplace_back(place_value(at.position_m));
        put_speed(at.speed_m_s, at.over_ground > 0, entry);
      }
      return value.put("waypoints", std::move(waypoints));
    }
    case Kind::hold:
      put_duration();
      return value;
    case Kind::follow_track:
      value.put("mmsi", static_cast<double>(task.follow->mmsi))
          .put("within_m", task.follow->within_m);
      if (task.follow->log) put_log(*task.follow->log, value);
      return value;
    case Kind::aboard:
      if (task.until_stand_by) value.put("until", "stand_by");
      put_duration();
      if (std::isinf(task.charger_w))
        value.put("battery", "swap");
      else if (task.charger_w > 0)
        value.put("battery", "charge").put("charger_w", task.charger_w);
      return value;
    case Kind::stand_by:
      return value;
    case Kind::actuators:
      put_duration();
      put_table(*task.table, value);
      return value;
    case Kind::manoeuvre:
      put_manoeuvre(*task.manoeuvre, value);
      return value;
  }
  return value;
}

const char* name_of(FollowerChoice follower) {
  switch (follower) {
    case FollowerChoice::line_of_sight:
      return "line_of_sight";
    case FollowerChoice::no_feed_forward:
      return "no_feed_forward";
    case FollowerChoice::paper:
      return "paper";
    case FollowerChoice::published_code:
      return "public";
  }
  return "";
}

YamlValue vehicle_value(const ScenarioVehicle& vehicle) {
  const ScenarioVehicle usual;
  YamlValue value;
  value.put("name", vehicle.name).put("model", vehicle.model);
  if (!vehicle.starts_on_track)
    value.put("start",
              place_value(vehicle.start_m).put("heading_deg", degrees_for(vehicle.heading_rad)));
  value.put("state_of_charge", vehicle.state_of_charge);
  if (vehicle.held_voltage_v > 0) value.put("hold_bus_v", vehicle.held_voltage_v);
  if (vehicle.depth_bound_m > 0) value.put("depth_bound_m", vehicle.depth_bound_m);
  if (vehicle.step_s) value.put("step_s", *vehicle.step_s);
  if (vehicle.speed_m_s) put_speed(*vehicle.speed_m_s, vehicle.is_speed_over_ground, value);
  if (vehicle.detail != usual.detail) value.put("detail", "coarse");
  if (vehicle.follower != usual.follower) value.put("follow", name_of(vehicle.follower));
  if (vehicle.tether) {
    YamlValue tether;
    if (vehicle.tether->top_m) tether.put("top", place_value(*vehicle.tether->top_m));
    value.put("tether", tether.put("length_m", vehicle.tether->length_m));
  }
  if (vehicle.carrier) {
    YamlValue carrier = on_board_value(vehicle.carrier->deck_m);
    value.put("carrier", carrier.put("name", vehicle.carrier->name));
  }
  if (!vehicle.keeps_clear) value.put("keeps_clear", false);
  if (vehicle.navigates_by_sensors) value.put("navigation", "sensors");
  if (vehicle.conduct) value.put("conduct", conduct_value(*vehicle.conduct));
  std::vector<YamlValue> tasks;
  for (const ScenarioTask& task : vehicle.tasks) tasks.push_back(task_value(task));
  return value.put("tasks", std::move(tasks));
}

YamlValue traffic_value(const ScenarioTraffic& traffic) {
  std::vector<YamlValue> logs, vessels;
  for (const AisLog& log : traffic.logs) {
    YamlValue& entry = logs.emplace_back();
    put_log(log, entry);
    if (!log.mmsi.empty())
      entry.put("mmsi", YamlValue::numbers(std::vector<double>(log.mmsi.begin(), log.mmsi.end())));
    entry.put("reach_km", multiple_for(log.reach_m, 1000));
  }
  for (const MadeUpVessel& vessel : traffic.vessels) {
    std::vector<YamlValue> places;
    for (const Triple<double>& place_m : vessel.places_m) places.push_back(plan_value(place_m));
    YamlValue& entry = vessels.emplace_back();
    entry.put("mmsi", static_cast<double>(vessel.mmsi));
    if (!vessel.name.empty()) entry.put("name", vessel.name);
    entry.put("begins_s", vessel.begins_s);
    put_speed(vessel.speed_m_s, false, entry);
    entry.put("waypoints", std::move(places));
  }
  YamlValue value;
  if (!logs.empty()) value.put("ais", std::move(logs));
  if (!vessels.empty()) value.put("vessels", std::move(vessels));
  return value.put("alarm", YamlValue()
                                .put("cpa_m", traffic.alarm.distance_m)
                                .put("tcpa_min", multiple_for(traffic.alarm.time_s, 60)));
}

YamlValue origin_value(const GeoPoint& origin) {
  return YamlValue()
      .put("latitude_deg", degrees_for(origin.latitude.radians()))
      .put("longitude_deg", degrees_for(origin.longitude.radians()));
}

YamlValue clearance_value(const StandOff& s) {
  return YamlValue()
      .put("craft_m", s.craft_m)
      .put("structure_m", s.structure_m)
      .put("tether_m", s.tether_m)
      .put("vessel_m", s.vessel_m)
      .put("vertical_m", s.vertical_m);
}

}  // namespace

std::string write_scenario(const Scenario& scenario) {
  YamlValue value;
  value.put("name", scenario.name).put("seed", static_cast<double>(scenario.seed));
  if (scenario.start) value.put("start", format_utc(*scenario.start));
  value.put("duration_s", scenario.duration_s)
      .put("step_s", scenario.step_s)
      .put("log_every_s", scenario.log_every_s)
      .put("home_after_s", scenario.home_after_s);
  if (scenario.has_origin) value.put("origin", origin_value(scenario.origin));
  value.put("water",
            std::visit([](const auto& water) { return water_value(water); }, scenario.water));
  if (scenario.member > 0) value.put("member", static_cast<double>(scenario.member));
  value.put("waves", waves_value(scenario.waves));
  if (scenario.gusts == GustModel::dryden) value.put("gusts", "dryden");
  if (scenario.has_wakes) value.put("wakes", true);
  if (scenario.logs_sensors) value.put("log", YamlValue().put("sensors", true));
  if (scenario.clearance) value.put("clearance", clearance_value(*scenario.clearance));
  if (!scenario.traffic.logs.empty() || !scenario.traffic.vessels.empty())
    value.put("traffic", traffic_value(scenario.traffic));
  std::vector<YamlValue> structures, vehicles;
  for (const ScenarioStructure& structure : scenario.structures)
    structures.push_back(structure_value(structure));
  for (const ScenarioVehicle& vehicle : scenario.vehicles)
    vehicles.push_back(vehicle_value(vehicle));
  if (!structures.empty()) value.put("structures", std::move(structures));
  value.put("vehicles", std::move(vehicles));
  return yaml_of(value);
}

}  // namespace slackwater::twin
