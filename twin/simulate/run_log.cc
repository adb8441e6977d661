#include "twin/simulate/run_log.h"

#include <algorithm>
#include <array>

#include "fields/base/check.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

constexpr std::array columns{
    LogColumn{"x", "", "m", "east of the origin", 1},
    LogColumn{"y", "", "m", "north of the origin", 1},
    LogColumn{"z", "", "m", "up from mean sea level", 1},
    LogColumn{"roll", "platform_roll", "rad", "roll, to starboard", 1},
    LogColumn{"pitch", "platform_pitch", "rad", "pitch, bow up", 1},
    LogColumn{"yaw", "platform_yaw", "rad", "heading of the bow, clockwise from north", 1},
    LogColumn{"velocity_body", "", "m s-1", "velocity over ground: ahead, to starboard, down", 3},
    LogColumn{"rate_body", "", "rad s-1", "rate of turn: roll, pitch, yaw", 3},
    LogColumn{"water_velocity", "", "m s-1",
              "water at the vehicle, current and waves: east, north, up", 3},
    LogColumn{"wind_velocity", "", "m s-1", "wind at the vehicle: east, north, up", 3},
    LogColumn{"surface_elevation", "", "m", "of the sea surface above still water", 1},
    LogColumn{"thrust", "", "N", "of each thruster", most_mounts},
    LogColumn{"thruster_state", "", "1", "behind its lag: command, shaft speed or thrust",
              most_mounts},
    LogColumn{"rudder", "", "rad", "positive: bow to starboard", 1},
    LogColumn{"elevator", "", "rad", "positive: bow up", 1},
    LogColumn{"moving_mass", "", "m", "forward of its middle", 1},
    LogColumn{"buoyancy_volume", "", "m3", "against neutral", 1},
    LogColumn{"electrical_power", "", "W", "drawn from the battery", 1},
    LogColumn{"bus_voltage", "", "V", "of the bus", 1},
    LogColumn{"battery_current", "", "A", "drawn from the battery", 1},
    LogColumn{"state_of_charge", "", "1", "1 full, 0 empty", 1},
    LogColumn{"battery_off", "", "1", "1: cut off or empty", 1},
    LogColumn{"charge_drawn", "", "C", "since the start", 1},
    LogColumn{"energy_delivered", "", "J", "by the battery since the start", 1},
    LogColumn{"fuel_burnt", "", "kg", "since the start", 1},
    LogColumn{"tether_tension", "", "N", "at the vehicle", 1},
    LogColumn{"across_track", "", "m", "from the leg under way, positive right of it", 1},
    LogColumn{"below_track", "", "m", "from the leg under way, positive below it", 1},
    LogColumn{"task", "", "1", "number of the task under way, from 0", 1},
    LogColumn{"halt", "", "1",
              "0 goes on, 1 diverged, 2 outside_area, 3 outside_time, 4 aground, 5 no_data, 6 "
              "struck",
              1},
};

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

std::span<const LogColumn> log_columns() noexcept { return columns; }

std::size_t log_row_size() noexcept {
  std::size_t sum = 0;
  for (const LogColumn& column : columns) sum += column.per;
  return sum;
}

void write_row(const Agent&, const AgentState& state, std::span<double> out) {
  expects(out.size() == log_row_size(), "a row has its size");
  const VehicleState<double>& v = state.vehicle;
  const EulerAngles angles = euler_angles(v.body.attitude);
  const TrackError off = track_error(state.mission, v.body.position_m);
  Pen pen{out};
  pen.put_enu(v.body.position_m);
  pen.put(angles.roll_rad);
  pen.put(angles.pitch_rad);
  pen.put(angles.yaw_rad);
  pen.put_body(v.body.nu.linear);
  pen.put_body(v.body.nu.angular);
  pen.put_enu(state.water_m_s);
  pen.put_enu(state.wind_m_s);
  pen.put(state.elevation_m);
  for (const double thrust : v.thrust_n) pen.put(thrust);
  for (const double behind : v.thruster) pen.put(behind);
  pen.put(v.rudder_rad);
  pen.put(v.elevator_rad);
  pen.put(v.moving_mass_m);
  pen.put(v.volume_m3);
  pen.put(v.electrical_w);
  pen.put(v.bus_voltage_v);
  pen.put(v.current_a);
  pen.put(v.battery.charge);
  pen.put(v.battery.off);
  pen.put(v.battery.drawn_c);
  pen.put(v.battery.delivered_j);
  pen.put(v.fuel_kg);
  pen.put(state.tether_n);
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
  rows.resize(agents.size());
  t_s.push_back(time_s);
  for (std::size_t i = 0; i < agents.size(); ++i) {
    rows[i].resize(rows[i].size() + size);
    write_row(agents[i], states[i], std::span(rows[i]).last(size));
  }
}

std::vector<double> RunLog::column(std::size_t vehicle, std::string_view name) const {
  std::size_t start = 0;
  for (const LogColumn& column : columns) {
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
