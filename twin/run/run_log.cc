#include "twin/run/run_log.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/wave/sea_sampling.h"
#include "twin/agent/conduct.h"
#include "twin/agent/hung_line.h"
#include "twin/body/frame.h"
#include "twin/body/waves_at_strips.h"

namespace slackwater::twin {
namespace {

constexpr std::array columns{
    LogVariable{"x", "", "m", "east of the origin", 1},
    LogVariable{"y", "", "m", "north of the origin", 1},
    LogVariable{"z", "", "m", "up from mean sea level", 1},
    LogVariable{"roll", "platform_roll", "rad", "roll, to starboard", 1},
    LogVariable{"pitch", "platform_pitch", "rad", "pitch, bow up", 1},
    LogVariable{"yaw", "platform_yaw", "rad", "heading of the bow, clockwise from north", 1},
    LogVariable{"velocity_body", "", "m s-1", "velocity over ground: ahead, to starboard, down", 3},
    LogVariable{"rate_body", "", "rad s-1", "rate of turn: roll, pitch, yaw", 3},
    LogVariable{"water_velocity", "", "m s-1",
                "water at the vehicle, current and waves: east, north, up", 3},
    LogVariable{"speed_through_water", "", "m s-1",
                "of the vehicle ahead, against the current without the waves", 1},
    LogVariable{"wind_velocity", "", "m s-1", "wind at the vehicle: east, north, up", 3},
    LogVariable{"surface_elevation", "", "m",
                "of the sea surface above still water, at the vehicle", 1},
    LogVariable{"thrust", "", "N", "of each thruster", most_mounts},
    LogVariable{"thruster_state", "", "1", "behind its lag: command, shaft speed or thrust",
                most_mounts},
    LogVariable{"rudder", "", "rad", "positive: bow to starboard", 1},
    LogVariable{"elevator", "", "rad", "positive: bow up", 1},
    LogVariable{"moving_mass", "", "m", "forward of its middle", 1},
    LogVariable{"buoyancy_volume", "", "m3", "against neutral", 1},
    LogVariable{"electrical_power", "", "W", "drawn from the battery, or from what is in its place",
                1},
    LogVariable{"electrical_energy", "", "J", "drawn since the start, whatever gave it", 1},
    LogVariable{"bus_voltage", "", "V", "of the bus", 1},
    LogVariable{"battery_current", "", "A", "drawn from the battery", 1},
    LogVariable{"state_of_charge", "", "1", "1 full, 0 empty", 1},
    LogVariable{"battery_off", "", "1", "1: cut off or empty", 1},
    LogVariable{"charge_drawn", "", "C", "since the start", 1},
    LogVariable{"energy_delivered", "", "J", "by the battery since the start", 1},
    LogVariable{"fuel_burnt", "", "kg", "since the start", 1},
    LogVariable{"tether_tension", "", "N", "at the vehicle", 1},
    LogVariable{"tether_top", "", "m", "where its tether hangs from: east, north, up", 3},
    LogVariable{"across_track", "", "m", "from the leg under way, positive right of it", 1},
    LogVariable{"below_track", "", "m",
                "from the leg under way or the place that is held, positive below it", 1},
    LogVariable{"task", "", "1", "number of the task under way, from 0", 1},
    LogVariable{"halt", "", "1",
                "0 goes on, 1 diverged, 2 outside_area, 3 outside_time, 4 aground, 5 no_data, 6 "
                "struck, 7 capsized, 8 no_headway",
                1},
};

constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
constexpr Triple<double> no_numbers{no_number, no_number, no_number};

/// What is around a vehicle at a time, NED.
struct Around {
  Triple<double> water_m_s = no_numbers;
  double through_m_s = no_number;
  Triple<double> wind_m_s = no_numbers;
  double elevation_m = 0;  ///< still water
};

void look_at_water(const Agent& agent, const BodyState<double>& body, const Rotation<double>& r,
                   double time_s, Around& around) {
  const FloatingHull& hull = agent.vehicle->body.hull;
  const double height_m = agent.vehicle->body.height_m;
  const Triple<double> at = body.position_m + r.to_ned(agent.vehicle->body.centre_of_buoyancy_m);
  const bool floats = hull.strips > 0;
  const WaterSample water =
      floats ? agent.water->current({at.x, at.y, std::max(at.z, 0.0)}, height_m, time_s)
             : agent.water->water(at, height_m, time_s);
  if (!has_value(water.status)) return;
  around.water_m_s = water.motion.velocity_m_s;
  around.through_m_s = body.nu.linear.x - r.to_body(water.current_m_s).x;
  const SeaRealisation* sea = agent.water->waves();
  if (sea == nullptr || !floats) return;
  const WaterAtStrips<double> strips = waves_at_strips(*sea, time_s, hull, body);
  around.water_m_s = around.water_m_s + moments_of(hull, strips.velocity_m_s).mean;
}

void look_at_surface(const Agent& agent, const BodyState<double>& body, double time_s,
                     Around& around) {
  const SeaRealisation* sea = agent.water->waves();
  if (sea == nullptr) return;
  const Vector3<Enu> at = enu_of(body.position_m);
  const WavePlace place{at.x(), at.y(), 0, time_s};
  sample_elevation(*sea, {&place, 1}, {&around.elevation_m, 1});
}

/// Gusts are those of the last step: they are drawn as it goes.
void look_at_wind(const Agent& agent, const AgentState& state, double time_s, Around& around) {
  const auto wind =
      agent.water->wind(wind_place_m(*agent.vehicle, state.vehicle.body.position_m), time_s);
  if (!has_value(wind.status)) return;
  around.wind_m_s = agent.gusts && time_s > 0 ? state.wind_m_s : wind.velocity_m_s;
}

Around around_of(const Agent& agent, const AgentState& state, double time_s) {
  const BodyState<double>& body = state.vehicle.body;
  const bool flies = agent.vehicle->kind == VehicleKind::uav;
  Around around;
  if (!flies) look_at_water(agent, body, rotation_of(body.attitude), time_s, around);
  if (flies || agent.vehicle->body.hull.strips > 0) look_at_wind(agent, state, time_s, around);
  look_at_surface(agent, body, time_s, around);
  return around;
}

/// Writes numbers one after the other.
struct Pen {
  std::span<double> out;
  std::size_t at = 0;
  void put(double value) { out[at++] = value; }
  void put_body(const Triple<double>& v) {
    put(v.x);
    put(v.y);
    put(v.z);
  }
  /// NED as ENU.
  void put_enu(const Triple<double>& ned) {
    const Vector3<Enu> enu = enu_of(ned);
    put(enu.x());
    put(enu.y());
    put(enu.z());
  }
};

}  // namespace

std::span<const LogVariable> log_variables() noexcept { return columns; }

std::size_t log_row_size() noexcept {
  std::size_t sum = 0;
  for (const LogVariable& column : columns) sum += column.per;
  return sum;
}

void write_row(const Agent& agent, const AgentState& state, double time_s, std::span<double> out) {
  expects(out.size() == log_row_size(), "a row has its size");
  const VehicleState<double>& v = state.vehicle;
  const EulerAngles angles = euler_angles(v.body.attitude);
  const TrackError off = track_error(way_of(state), v.body.position_m);
  const Around around = around_of(agent, state, time_s);
  Pen pen{out};
  pen.put_enu(v.body.position_m);
  pen.put(angles.roll_rad);
  pen.put(angles.pitch_rad);
  pen.put(angles.yaw_rad);
  pen.put_body(v.body.nu.linear);
  pen.put_body(v.body.nu.angular);
  pen.put_enu(around.water_m_s);
  pen.put(around.through_m_s);
  pen.put_enu(around.wind_m_s);
  pen.put(around.elevation_m);
  for (const double thrust : v.thrust_n) pen.put(thrust);
  for (const double behind : v.thruster) pen.put(behind);
  pen.put(v.rudder_rad);
  pen.put(v.elevator_rad);
  pen.put(v.moving_mass_m);
  pen.put(v.volume_m3);
  pen.put(v.electrical_w);
  pen.put(v.drawn_j);
  const bool has_battery = agent.vehicle->battery.has_value();
  const auto of_battery = [&](double value) { pen.put(has_battery ? value : no_number); };
  pen.put(has_battery || agent.plan.held_voltage_v > 0 ? v.bus_voltage_v : no_number);
  of_battery(v.current_a);
  of_battery(v.battery.charge);
  of_battery(v.battery.off);
  of_battery(v.battery.drawn_c);
  of_battery(v.battery.delivered_j);
  pen.put(burns_fuel(*agent.vehicle) ? v.fuel_kg : no_number);
  pen.put(state.tether_n);
  pen.put_enu(has_line_out(agent, state) ? state.top.at(time_s) : no_numbers);
  pen.put(off.across_m);
  pen.put(off.below_m);
  pen.put(static_cast<double>(state.mission.task));
  pen.put(static_cast<double>(state.halt));
  expects(pen.at == out.size(), "a row has all its columns");
}

void RunLog::reserve(std::size_t vehicles, std::size_t times) {
  t_s.reserve(times);
  rows.resize(vehicles);
  for (std::vector<double>& row : rows) row.reserve(times * log_row_size());
}

void RunLog::append(double time_s, std::span<const Agent> agents,
                    std::span<const AgentState> states) {
  const std::size_t size = log_row_size();
  let_join(agents.size());
  t_s.push_back(time_s);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    rows[i].resize(rows[i].size() + size);
    write_row(agents[i], states[i], time_s, std::span(rows[i]).last(size));
  }
}

void RunLog::let_join(std::size_t vehicles) {
  rows.resize(vehicles);
  for (std::vector<double>& row : rows) row.resize(t_s.size() * log_row_size(), no_number);
}

std::size_t RunLog::first_time(std::size_t vehicle) const {
  const std::size_t size = log_row_size();
  const std::vector<double>& row = rows.at(vehicle);
  std::size_t time = 0;
  while (time * size < row.size() && std::isnan(row[time * size])) ++time;  // its x
  return time;
}

std::vector<double> RunLog::column(std::size_t vehicle, std::string_view name) const {
  std::size_t start = 0;
  for (const LogVariable& column : columns) {
    if (column.name == name) {
      std::vector<double> out;
      const std::size_t size = log_row_size();
      const std::vector<double>& row = rows.at(vehicle);
      for (std::size_t i = start; i < row.size(); i += size)
        out.insert(out.end(), row.begin() + static_cast<std::ptrdiff_t>(i),
                   row.begin() + static_cast<std::ptrdiff_t>(i + column.per));
      return out;
    }
    start += column.per;
  }
  expects(false, "the log has this column");
  return {};
}

}  // namespace slackwater::twin
