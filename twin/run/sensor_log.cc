#include "twin/run/sensor_log.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fields/base/check.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

constexpr double adcp_every_s = 60;

/// Writes numbers one after the other; what nobody gives stays NaN.
struct SensorPen {
  std::span<double> out;
  std::size_t at = 0;
  void put(double value) { out[at++] = value; }
  void put(const Triple<double>& v) {
    put(v.x);
    put(v.y);
    put(v.z);
  }
  void put_enu(const Triple<double>& ned) {
    const Vector3<Enu> enu = enu_of(ned);
    put(enu.x());
    put(enu.y());
    put(enu.z());
  }
  void skip(std::size_t numbers) { at += numbers; }
};

NoiseStream stream_of(std::uint64_t seed, const Agent& agent, const char* instrument,
                      std::size_t row) {
  return {seed, "twin/" + std::string(instrument) + "/" + agent.name + "/" + std::to_string(row)};
}

void put_nearest_echo(const RangeSonar& sonar, NoiseStream noise, const Scene& scene,
                      const BodyState<double>& body, SensorPen& pen) {
  const auto echoes = measured(sonar, noise, scene, body.position_m, rotation_of(body.attitude));
  const SonarEcho* nearest = nullptr;
  for (const SonarEcho& echo : echoes)
    if (echo.range_m && (nearest == nullptr || *echo.range_m < *nearest->range_m)) nearest = &echo;
  pen.put(nearest != nullptr ? *nearest->range_m : nothing_shown);
  pen.put(nearest != nullptr ? nearest->bearing_rad : nothing_shown);
}

void put_profile(const Adcp& adcp, NoiseStream noise, const SensedWater& water,
                 const BodyState<double>& body, std::span<double> out) {
  const Rotation<double> r = rotation_of(body.attitude);
  const WaterAt flow = [&water](const Triple<double>& at_m) {
    return water.sampler.current(at_m, 0, water.t_s).current_m_s;
  };
  const auto bins = measured(adcp, noise, scene_at(water, body.position_m), flow, body.position_m,
                             r, r.to_ned(body.nu.linear));
  const std::size_t most = out.size() / 4;
  for (std::size_t i = 0; i < std::min(most, bins.size()); ++i) {
    out[i] = bins[i].down_m;
    if (!bins[i].velocity_m_s) continue;
    const Vector3<Enu> velocity_m_s = enu_of(*bins[i].velocity_m_s);
    out[most + i] = velocity_m_s.x();
    out[2 * most + i] = velocity_m_s.y();
    out[3 * most + i] = velocity_m_s.z();
  }
}

}  // namespace

SensorLog::SensorLog(std::span<const Agent> agents, bool with_readings, std::uint64_t seed)
    : seed_(seed) {
  rows.resize(agents.size());
  for (const Agent& agent : agents) {
    const Sensors& sensors = agent.vehicle->sensors;
    if (with_readings) {
      needs_.sonar |= sensors.sonar.has_value();
      if (sensors.adcp)
        needs_.adcp_bins = std::max(needs_.adcp_bins, static_cast<std::size_t>(sensors.adcp->bins));
    }
    if (!agent.navigation) continue;
    needs_.error = true;
    if (!with_readings) continue;
    needs_.gnss |= sensors.gnss.has_value();
    needs_.dvl |= sensors.dvl.has_value();
    needs_.depth |= sensors.depth.has_value();
    needs_.compass = needs_.imu = true;
  }
  add_columns();
  for (const LogVariable& column : columns_) row_size_ += column.per;
}

void SensorLog::add_columns() {
  const auto add = [&](bool is_needed, const LogVariable& column) {
    if (is_needed) columns_.push_back(column);
  };
  add(needs_.error, {"navigation_error", "", "m",
                     "where the vehicle takes itself to be less where it is: east, north, up", 3});
  add(needs_.gnss, {"gnss_position", "", "m", "fix: east, north, up of the origin", 3});
  add(needs_.gnss, {"gnss_velocity", "", "m s-1", "of the fix: east, north, up", 3});
  add(needs_.dvl,
      {"dvl_velocity", "", "m s-1", "against the bed or the water: ahead, to starboard, down", 3});
  add(needs_.dvl, {"dvl_bottom_track", "", "1", "1: against the bed, 0: against the water", 1});
  add(needs_.dvl, {"dvl_altitude", "", "m", "above the bed, mean of the beams", 1});
  add(needs_.depth, {"measured_depth", "depth", "m", "by pressure, below the surface", 1});
  add(needs_.compass, {"compass_heading", "", "rad", "shown, clockwise from north", 1});
  add(needs_.imu, {"measured_rate_body", "", "rad s-1", "gyros: roll, pitch, yaw", 3});
  add(needs_.imu, {"measured_specific_force", "", "m s-2",
                   "accelerometers: ahead, to starboard, down; (0, 0, -g) at rest", 3});
  add(needs_.sonar, {"sonar_range", "", "m", "of the nearest echo", 1});
  add(needs_.sonar,
      {"sonar_bearing", "", "rad", "of the nearest echo, to the right of forward", 1});
  const std::size_t bins = needs_.adcp_bins;
  add(bins > 0, {"adcp_depth", "depth", "m", "of the middle of each bin", bins});
  add(bins > 0,
      {"adcp_eastward_velocity", "eastward_sea_water_velocity", "m s-1", "of each bin", bins});
  add(bins > 0,
      {"adcp_northward_velocity", "northward_sea_water_velocity", "m s-1", "of each bin", bins});
  add(bins > 0,
      {"adcp_upward_velocity", "upward_sea_water_velocity", "m s-1", "of each bin", bins});
}

void SensorLog::reserve(std::size_t most_times) {
  for (std::vector<double>& row : rows) row.reserve(most_times * row_size_);
}

void SensorLog::append(double time_s, std::span<const Agent> agents,
                       std::span<const AgentState> states) {
  let_join(agents.size());
  if (row_size_ > 0) {
    for (std::size_t i = 0; i < agents.size(); ++i) {
      rows[i].resize(rows[i].size() + row_size_, nothing_shown);
      write(time_s, agents[i], states[i], std::span(rows[i]).last(row_size_));
    }
  }
  ++times;
  last_s = time_s;
}

void SensorLog::let_join(std::size_t vehicles) {
  rows.resize(vehicles);
  for (std::vector<double>& row : rows) row.resize(times * row_size_, nothing_shown);
}

void SensorLog::write(double time_s, const Agent& agent, const AgentState& state,
                      std::span<double> out) {
  const Sensors& sensors = agent.vehicle->sensors;
  const bool navigates = agent.navigation.has_value();
  const Shown& shown = state.navigation.instruments.shown;
  const BodyState<double>& body = state.vehicle.body;
  const SensedWater water{*agent.water, state.elevation_m, time_s};
  SensorPen pen{out};
  const auto put = [&](bool is_needed, bool has, std::size_t numbers, const auto& writes) {
    if (!is_needed) return;
    if (has)
      writes();
    else
      pen.skip(numbers);
  };
  put(needs_.error, navigates, 3, [&] { pen.put_enu(state.navigation.error_m); });
  put(needs_.gnss, navigates && sensors.gnss, 6, [&] {
    pen.put_enu(shown.gnss_position_m);
    pen.put_enu(shown.gnss_velocity_m_s);
  });
  put(needs_.dvl, navigates && sensors.dvl, 5, [&] {
    pen.put(shown.dvl_velocity_m_s);
    pen.put(shown.dvl_is_bottom);
    pen.put(shown.dvl_altitude_m);
  });
  put(needs_.depth, navigates, 1, [&] { pen.put(shown.depth_m); });
  put(needs_.compass, navigates, 1, [&] { pen.put(shown.heading_rad); });
  put(needs_.imu, navigates, 6, [&] {
    pen.put(shown.turn_rate_rad_s);
    pen.put(shown.specific_force_m_s2);
  });
  const bool looks = state.halt == Halt::none;
  put(needs_.sonar, looks && sensors.sonar, 2, [&] {
    put_nearest_echo(*sensors.sonar, stream_of(seed_, agent, "sonar", times),
                     scene_at(water, body.position_m), body, pen);
  });
  const std::size_t numbers = 4 * needs_.adcp_bins;
  const auto minute_of = [](double t_s) { return std::floor(t_s / adcp_every_s + 1e-9); };
  const bool is_minute = minute_of(time_s) > minute_of(last_s);
  put(numbers > 0, false, numbers, [] {});
  if (numbers > 0 && looks && sensors.adcp && is_minute)
    put_profile(*sensors.adcp, stream_of(seed_, agent, "adcp", times), water, body,
                out.last(numbers));
  expects(pen.at == out.size(), "a row has all its columns");
}

std::vector<double> SensorLog::column(std::size_t vehicle, std::string_view name) const {
  std::size_t start = 0;
  for (const LogVariable& column : columns_) {
    if (column.name == name) {
      std::vector<double> out;
      const std::vector<double>& row = rows.at(vehicle);
      for (std::size_t i = start; i < row.size(); i += row_size_)
        out.insert(out.end(), row.begin() + static_cast<std::ptrdiff_t>(i),
                   row.begin() + static_cast<std::ptrdiff_t>(i + column.per));
      return out;
    }
    start += column.per;
  }
  expects(false, "the sensor log has this column");
  return {};
}

}  // namespace slackwater::twin
