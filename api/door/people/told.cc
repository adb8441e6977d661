#include "api/door/people/told.h"

#include <cmath>

#include "api/door/people/rounded.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"

namespace slackwater::people {
namespace {

using nlohmann::json;

json or_null(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

template <typename Value>
json or_null(const std::optional<Value>& value) {
  return value ? json(*value) : json(nullptr);
}

json degrees(double angle_rad) { return rounded(angle_rad / constants::degree, 0.1); }

json seat_or_null(unsigned seat) { return seat == 0 ? json(nullptr) : json(seat); }

json farm_json(const FarmNow& farm) {
  json each = json::array();
  for (const TurbineNow& turbine : farm.turbines) {
    json wind_left = json::array();
    for (const double share : turbine.wind_left) wind_left.push_back(rounded(share, 1e-3));
    each.push_back({{"power_w", rounded(turbine.power_w, 1e4)},
                    {"wind_m_s", rounded(turbine.wind_m_s, 0.01)},
                    {"rotor_speed_rad_s", rounded(turbine.rotor_speed_rad_s, 1e-3)},
                    {"wind_left", wind_left}});
  }
  return {{"power_w", rounded(farm.power_w, 1e4)},
          {"rated_w", farm.rated_w},
          {"turbines", farm.turbines.size()},
          {"each", each}};
}

}  // namespace

json place_json(const twin::Triple<double>& ned_m) {
  return {{"east_m", ned_m.y}, {"north_m", ned_m.x}, {"up_m", -ned_m.z}};
}

std::string text_of(const json& json) {
  return json.dump(-1, ' ', false, json::error_handler_t::replace);
}

json seat_json(const Seat& seat) {
  return {{"seat", seat.number},
          {"name", seat.name},
          {"role", name_of(seat.role)},
          {"is_here", seat.is_here},
          {"kept_until", or_null(seat.kept_until)}};
}

json vehicle_json(const twin::Agent& agent, std::size_t place, const VehicleNow& now) {
  const twin::Vehicle& vehicle = *agent.vehicle;
  const twin::Envelope envelope = agent.conduct ? agent.conduct->plan.envelope : twin::Envelope();
  json names = json::array();
  for (std::size_t i = 0; i < vehicle.mounts; ++i) names.push_back(formatted("{}", i + 1));
  const auto forward_right_down = [](const twin::Triple<double>& body) {
    return json{rounded(body.x, 1e-3), rounded(body.y, 1e-3), rounded(body.z, 1e-3)};
  };
  json mounts = json::array();
  for (std::size_t i = 0; i < vehicle.mounts; ++i)
    mounts.push_back({{"at", forward_right_down(vehicle.mount[i].position_m)},
                      {"axis", forward_right_down(vehicle.mount[i].direction)}});
  json tether = nullptr;
  if (agent.tether) {
    tether = place_json(agent.tether_top_m);
    tether["length_m"] = agent.tether->longest_m;
  }
  json zone = nullptr;
  if (now.zone) {
    zone = place_json(now.zone->centre_m);
    zone["radius_m"] = now.zone->radius_m;
  }
  return {{"vehicle", place},
          {"name", agent.name},
          {"model", vehicle.id},
          {"kind", twin::name_of(vehicle.kind)},
          {"length_m", 2 * vehicle.body.radius_m},
          {"width_m", 2 * vehicle.body.radius_m},
          {"thrusters", vehicle.mounts},
          {"thruster_names", names},
          {"mounts", mounts},
          {"cruise_m_s", vehicle.cruise_speed_m_s},
          {"most_speed_m_s", envelope.most_speed_m_s > 0 ? json(envelope.most_speed_m_s) : nullptr},
          {"stand_off_m", envelope.stand_off_m > 0 ? json(envelope.stand_off_m) : nullptr},
          {"fence_m", or_null(envelope.fence_m)},
          {"home", place_json(now.home_m)},
          {"tether", tether},
          {"zone", zone}};
}

json structure_json(const twin::Structure& structure, std::size_t place) {
  if (const auto* c = std::get_if<twin::Cylinder>(&structure))
    return {{"name", formatted("structure {}", place + 1)},
            {"east_m", c->east_m},
            {"north_m", c->north_m},
            {"radius_m", c->radius_m},
            {"bottom_m", -c->bottom_m},
            {"top_m", -c->top_m}};
  const auto& box = std::get<twin::Box>(structure);
  return {{"name", formatted("structure {}", place + 1)},
          {"east_m", box.centre_m.y},
          {"north_m", box.centre_m.x},
          {"radius_m", std::hypot(box.half_size_m.x, box.half_size_m.y)},
          {"bottom_m", -box.centre_m.z - box.half_size_m.z},
          {"top_m", -box.centre_m.z + box.half_size_m.z}};
}

json sea_json(const SeaRealisation* sea) {
  if (sea == nullptr || sea->waves().empty()) return nullptr;
  json waves = json::array();
  for (const WaveComponent& wave : sea->waves())
    waves.push_back({wave.amplitude_m, wave.wavenumber_rad_m.real(), wave.wavenumber_rad_m.imag(),
                     wave.absolute_rad_s, wave.phase_rad});
  return {{"depth_m", sea->water().depth_m}, {"waves", waves}};
}

json water_json(const api::ScenarioWater& water) {
  const bool is_made_up = water.forecast_sha256.empty();
  return {{"forecast", is_made_up ? json(nullptr) : json(water.forecast_name)}};
}

json turbines_json(const std::optional<twin::StandingTurbines>& turbines) {
  if (!turbines) return nullptr;
  json places = json::array();
  for (const Horizontal at_m : turbines->at_m) places.push_back({at_m.real(), at_m.imag()});
  return {{"hub_height_m", turbines->kind->hub_height_m},
          {"rotor_diameter_m", turbines->kind->rotor_diameter_m},
          {"rated_w", turbines->kind->rated_power_w},
          {"curve", curve_json(*turbines->kind)},
          {"places", places}};
}

json curve_json(const Turbine& kind) {
  constexpr double curve_step_m_s = 0.5;
  json curve = json::array();
  const auto steps =
      static_cast<std::size_t>(std::ceil(kind.cut_out_speed_m_s / curve_step_m_s)) + 2;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double wind_m_s = curve_step_m_s * static_cast<double>(i);
    curve.push_back({wind_m_s, rounded(kind.power_w(wind_m_s), 1e3)});
  }
  return curve;
}

json thrust_json(std::size_t vehicle, const VehicleNow& now) {
  json shares = json::array();
  for (const double share : now.thrust) shares.push_back(rounded(share, 0.02));
  return {{"is", "thrust"}, {"vehicle", vehicle}, {"share", shares}};
}

json thrust_row_json(std::size_t vehicle, const VehicleNow& now) {
  json row = json::array({vehicle});
  for (const double share : now.thrust) row.push_back(2 * std::lround(50 * share));
  return row;
}

json line_json(std::size_t vehicle, const VehicleNow& now) {
  json nodes = json::array();
  for (const twin::Triple<double>& at_m : now.line_m)
    nodes.push_back({rounded(at_m.y, 0.01), rounded(at_m.x, 0.01), rounded(-at_m.z, 0.01)});
  return {{"is", "line"}, {"vehicle", vehicle}, {"nodes", nodes}};
}

json traffic_json(const Surroundings& around) {
  json vessels = json::array();
  for (const VesselNow& vessel : around.vessels) {
    const double speed_m_s = std::abs(vessel.velocity_m_s);
    vessels.push_back(
        {{"mmsi", vessel.mmsi},
         {"name", vessel.name},
         {"east_m", rounded(vessel.east_m, 0.1)},
         {"north_m", rounded(vessel.north_m, 0.1)},
         {"course_deg",
          speed_m_s > 0 ? rounded(to_direction_deg(vessel.velocity_m_s), 1) : json(nullptr)},
         {"speed_m_s", rounded(speed_m_s, 0.01)},
         {"length_m", or_null(vessel.length_m)}});
  }
  return {{"is", "traffic"}, {"vessels", vessels}, {"left_out", around.vessels_left_out}};
}

json weather_json(const Surroundings& around, double time_s, const std::optional<FarmNow>& farm,
                  const std::string& led_by) {
  json told{{"is", "weather"}};
  const auto put = [&](const std::string& what, const std::optional<Horizontal>& m_s,
                       const char* direction, double (*direction_deg)(Horizontal)) {
    told[what + "_m_s"] = m_s ? rounded(std::abs(*m_s), 0.01) : json(nullptr);
    told[what + direction] =
        m_s && std::abs(*m_s) > 0 ? rounded(direction_deg(*m_s), 1) : json(nullptr);
  };
  put("wind", around.wind_10m_m_s, "_from_deg", from_direction_deg);
  put("hub_wind", around.hub_wind_m_s, "_from_deg", from_direction_deg);
  put("current", around.current_m_s, "_to_deg", to_direction_deg);
  const SeaState sea = around.sea.value_or(SeaState{std::nan(""), std::nan(""), std::nan("")});
  told["waves_m"] = rounded(sea.significant_height_m, 0.01);
  told["waves_period_s"] = rounded(sea.peak_period_s, 0.1);
  told["waves_from_deg"] = rounded(sea.from_direction_deg, 1);
  told["waves_factor"] = rounded(around.waves_factor, 1e-3);
  told["visibility_m"] = or_null(around.visibility_m);
  told["water_visibility_m"] = or_null(around.water_visibility_m);
  json led = json::array();
  const twin::WeatherAsked& asked = around.asked;
  if (asked.wind_10m_m_s) led.push_back("wind");
  if (asked.significant_wave_height_m) led.push_back("waves");
  if (asked.current_m_s) led.push_back("current");
  if (asked.visibility_m) led.push_back("visibility");
  if (asked.water_visibility_m) led.push_back("water_visibility");
  told["led"] = led;
  told["led_by"] = led.empty() || led_by.empty() ? json(nullptr) : json(led_by);
  told["settles_in_s"] = std::max(0.0, std::ceil(around.settled_s - time_s));
  told["sun"] = {{"elevation_deg", rounded(around.sun.elevation_deg, 0.1)},
                 {"azimuth_deg", rounded(around.sun.azimuth_deg, 0.1)}};
  told["currents"] = json::array();
  for (const CurrentAtDepth& at : around.currents)
    told["currents"].push_back({rounded(-at.depth_m, 0.01), rounded(at.towards_m_s.real(), 1e-3),
                                rounded(at.towards_m_s.imag(), 1e-3)});
  told["farm"] = farm ? farm_json(*farm) : json(nullptr);
  return told;
}

json helm_json(std::size_t vehicle, const ShownHelm& shown) {
  const HelmNow& helm = shown.helm;
  json holder = nullptr;
  if (helm.seat != 0) holder = helm.seat;
  if (helm.seat == 0 && !helm.agent.empty()) holder = helm.agent;
  return {{"is", "helm"},
          {"vehicle", vehicle},
          {"state", name_of(helm.state)},
          {"holder", holder},
          {"asker", seat_or_null(helm.asker)},
          {"until", or_null(helm.until)},
          {"mode", twin::name_of(shown.mode)},
          {"cause", twin::name_of(shown.cause)},
          {"home_at", or_null(shown.home_at)},
          {"is_raw", helm.is_raw}};
}

json status_json(std::size_t vehicle, const VehicleNow& now) {
  json waypoints = json::array();
  for (const twin::Waypoint& waypoint : now.waypoints)
    waypoints.push_back(place_json(waypoint.position_m));
  json alarms = json::array();
  for (const auto& [alarm, name, acknowledged_by] : now.alarms)
    alarms.push_back(
        {{"mmsi", alarm.id},
         {"name", name},
         {"is_lost", alarm.status == twin::AlarmStatus::lost},
         {"cpa_m", rounded(alarm.approach.distance_m, 1)},
         {"cpa_s", rounded(alarm.approach.time_s, 1)},
         {"acknowledged_by", acknowledged_by.empty() ? json(nullptr) : json(acknowledged_by)}});
  const json camera{{"pan_deg", degrees(now.camera.pan_rad)},
                    {"tilt_deg", degrees(now.camera.tilt_rad)},
                    {"zoom", rounded(now.camera.zoom, 0.01)}};
  return {
      {"is", "status"},           {"vehicle", vehicle},       {"doing", now.words.doing},
      {"cause", now.words.cause}, {"phase", now.words.phase}, {"halt", now.words.halt},
      {"task", now.words.task},   {"tasks", now.words.tasks}, {"waypoints", waypoints},
      {"alarms", alarms},         {"reserve", now.advice},    {"margin_s", or_null(now.margin_s)},
      {"camera", camera}};
}

json reserve_json(std::size_t vehicle, const VehicleNow& now) {
  return json::array({vehicle, now.advice, rounded(now.margin_s, 1)});
}

}  // namespace slackwater::people
