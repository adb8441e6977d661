#include <algorithm>
#include <map>

#include "fields/base/text.h"
#include "fields/service/place.h"
#include "twin/tether/read_tether.h"
#include "twin/vehicle/balance.h"
#include "twin/vehicle/read_body.h"
#include "twin/vehicle/read_derivatives.h"
#include "twin/vehicle/read_fins.h"
#include "twin/vehicle/read_mounts.h"
#include "twin/vehicle/vehicle.h"
#include "twin/vehicle/vehicle_of.h"

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

Vehicle vehicle_of(const Config& config, const std::filesystem::path& data_folder) {
  Vehicle vehicle;
  vehicle.places = config.places();
  vehicle.id = config.text("id");
  vehicle.name = config.text("name");
  vehicle.kind = read_kind(config);
  vehicle.largest_step_s = config.number("largest_step_s", {1e-4, 1});
  if (vehicle.kind == VehicleKind::uav && vehicle.largest_step_s > 0.004)
    config.refuse("largest_step_s",
                  "a multirotor turns over in tenths of a second; expected at most 0.004");
  vehicle.body = read_body(config);
  if (const auto driven = motion_driven_by_damping(vehicle.body))
    vehicle.warnings.push_back(*driven);
  const bool floats = vehicle.body.hull.strips > 0;
  const bool is_surface_craft =
      vehicle.kind == VehicleKind::usv || vehicle.kind == VehicleKind::vessel;
  if (floats != is_surface_craft)
    config.refuse(
        "kind", is_surface_craft ? "a surface craft has hulls" : "only usv and vessel have hulls");
  if (floats)
    (void)floating_depth_m(vehicle.body.hull, vehicle.body.mass_kg,
                           vehicle.body.fluid_density_kg_m3);
  read_mounts(config, data_folder, vehicle);
  read_fins(config, vehicle);
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
  for (const VehicleFinding& finding : findings_on(vehicle, balance_of(vehicle))) {
    if (finding.is_error) config.refuse(finding.key, finding.what);
    vehicle.warnings.push_back(std::string(finding.key) + ": " + finding.what);
  }
  return vehicle;
}

Vehicle read_vehicle(const std::filesystem::path& file, const std::filesystem::path& data_folder) {
  return vehicle_of(Config::load(file), data_folder);
}

}  // namespace slackwater::twin
