#include <algorithm>
#include <cmath>
#include <map>

#include "fields/base/text.h"
#include "fields/service/place.h"
#include "twin/tether/read_tether.h"
#include "twin/vehicle/balance.h"
#include "twin/vehicle/read_body.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {
namespace {

VehicleKind read_kind(const Config& config) {
  static const std::map<std::string, VehicleKind, std::less<>> kinds{
      {"rov", VehicleKind::rov},
      {"auv", VehicleKind::auv},
      {"uav", VehicleKind::uav},
      {"usv", VehicleKind::usv},
      {"vessel", VehicleKind::vessel}};
  const std::string kind = config.text("kind");
  const auto found = kinds.find(kind);
  if (found == kinds.end())
    config.refuse("kind", "found " + kind + ", expected rov, auv, uav, usv or vessel");
  return found->second;
}

Triple<double> read_triple(const Config& config, std::string_view key, Range range) {
  const std::vector<double> v = config.numbers(key, range);
  if (v.size() != 3)
    config.refuse(key, "found " + std::to_string(v.size()) + " numbers; give three, [x, y, z]");
  return {v[0], v[1], v[2]};
}

Mount read_mount(const Config& config) {
  Mount mount;
  mount.position_m = read_triple(config, "position_m", {-100, 100});
  const Triple<double> d = read_triple(config, "direction", {-1, 1});
  const double length = std::sqrt(dot(d, d));
  if (std::abs(length - 1) > 1e-3)
    config.refuse("direction",
                  "its length is " + std::to_string(length) + "; give a direction of length 1");
  mount.direction = (1 / length) * d;
  if (const auto turns = config.optional_text("turns")) {
    if (*turns != "clockwise" && *turns != "counterclockwise")
      config.refuse("turns", "found " + *turns +
                                 ", expected clockwise or counterclockwise, seen along the thrust");
    mount.spin = *turns == "clockwise" ? 1 : -1;
  }
  return mount;
}

void read_mounts(const Config& config, Vehicle& vehicle) {
  const std::vector<Config> mounts = config.children("mounts");
  if (mounts.empty() || mounts.size() > most_mounts) {
    config.refuse("mounts", "found " + std::to_string(mounts.size()) +
                                " thrusters, expected 1 to " + std::to_string(most_mounts));
  }
  for (const Config& mount : mounts) vehicle.mount[vehicle.mounts++] = read_mount(mount);
}

Fins read_fins(const Config& config) {
  Fins fins;
  const auto c = config.optional_child("fins");
  if (!c) return fins;
  fins.area_m2 = c->number("area_m2", {1e-5, 100});
  fins.position_x_m = c->number("position_x_m", {-100, 100});
  fins.lift_slope_per_rad = c->number("lift_slope_per_rad", {0.1, 2 * constants::pi});
  fins.drag_factor = c->number("drag_factor", {0, 2});
  fins.stall_rad = c->number("stall_rad", {0.01, 0.8});
  fins.limit_rad = c->number("limit_rad", {0.01, 1.2});
  fins.rate_rad_s = c->number("rate_rad_s", {0.001, 20});
  return fins;
}

Trim read_trim(const Config& config) {
  Trim trim;
  const auto c = config.optional_child("trim");
  if (!c) return trim;
  trim.moving_mass_kg = c->number("moving_mass_kg", {0, 1e5});
  trim.travel_m = c->number("travel_m", {0, 10});
  trim.travel_rate_m_s = c->number("travel_rate_m_s", {0, 1});
  trim.least_volume_m3 = c->number("least_volume_m3", {-10, 0});
  trim.most_volume_m3 = c->number("most_volume_m3", {0, 10});
  trim.volume_rate_m3_s = c->number("volume_rate_m3_s", {0, 1});
  return trim;
}

void read_wind(const Config& config, Vehicle& vehicle) {
  const auto c = config.optional_child("wind_force");
  if (!c) return;
  vehicle.wind_force_n_s2_m2 = {c->number("x_n_s2_m2", {0, 1e5}), c->number("y_n_s2_m2", {0, 1e5}),
                                0};
  vehicle.wind_yaw_n_m_s2_m2 = c->number("yaw_n_m_s2_m2", {-1e6, 1e6});
  const auto height_m = c->optional_number("wind_height_m", {lowest_wind_m, highest_wind_m});
  if (!height_m)
    vehicle.warnings.push_back(formatted(
        "wind_force: found no wind_height_m, took {:g} m; give the height of the wind that its "
        "coefficients are for, as their source says it",
        vehicle.wind_height_m));
  vehicle.wind_height_m = height_m.value_or(vehicle.wind_height_m);
}

}  // namespace

Vehicle read_vehicle(const std::filesystem::path& file, const std::filesystem::path& data_folder) {
  const Config config = Config::load(file);
  Vehicle vehicle;
  vehicle.id = config.text("id");
  vehicle.name = config.text("name");
  vehicle.kind = read_kind(config);
  vehicle.largest_step_s = config.number("largest_step_s", {1e-4, 1});
  if (vehicle.kind == VehicleKind::uav && vehicle.largest_step_s > 0.004)
    config.refuse("largest_step_s",
                  "a multirotor turns over in tenths of a second; expected at most 0.004");
  vehicle.body = read_body(config);
  const bool floats = vehicle.body.hull.strips > 0;
  const bool is_surface_craft =
      vehicle.kind == VehicleKind::usv || vehicle.kind == VehicleKind::vessel;
  if (floats != is_surface_craft)
    config.refuse(
        "kind", is_surface_craft ? "a surface craft has hulls" : "only usv and vessel have hulls");
  if (floats)
    (void)floating_depth_m(vehicle.body.hull, vehicle.body.mass_kg,
                           vehicle.body.fluid_density_kg_m3);
  const Config thruster = config.child("thruster");
  vehicle.thruster = read_thruster(thruster, data_folder);
  read_mounts(config, vehicle);
  vehicle.fins = read_fins(config);
  vehicle.trim = read_trim(config);
  read_wind(config, vehicle);
  if (const auto battery = config.optional_child("battery"))
    vehicle.battery = read_battery(*battery, data_folder);
  vehicle.hotel_w = config.number("hotel_w", {0, 1e6});
  vehicle.cruise_speed_m_s = config.number("cruise_speed_m_s", {0.01, 40});
  vehicle.rated_depth_m = config.optional_number("rated_depth_m", {0.5, 12000});
  vehicle.autopilot = read_autopilot(config, vehicle.kind, vehicle.largest_step_s);
  vehicle.tether = read_tether(config);
  vehicle.sensors = read_sensors(config);
  if (vehicle.tether) {
    // The lightest way it has: what a pull moves at once.
    double heaviest = 0;
    for (std::size_t i = 0; i < 3; ++i)
      heaviest = std::max(heaviest, vehicle.body.inverse_mass.entry[i][i]);
    vehicle.tether->vehicle_mobility_per_kg = heaviest;
    vehicle.tether->water_density_kg_m3 = vehicle.body.fluid_density_kg_m3;
  }
  config.expect_all_read();
  for (const BalanceFinding& finding : findings_on(vehicle, balance_of(vehicle))) {
    if (finding.is_error) config.refuse(finding.key, finding.what);
    vehicle.warnings.push_back(std::string(finding.key) + ": " + finding.what);
  }
  return vehicle;
}

}  // namespace slackwater::twin
