#include "api/door/people/surroundings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "twin/body/frame.h"

namespace slackwater::people {
namespace {

constexpr std::size_t most_vessels = 30;  ///< that are shown
constexpr double anemometer_m = 10;
constexpr std::size_t current_layers = 16;
constexpr double layers_to_m = 80;  ///< where nobody knows the bed

/// From the surface down to the bed, as far as the field goes.
std::vector<CurrentAtDepth> currents_of(const twin::EnvironmentSampler& water, double t_s) {
  const BedSample bed = water.bed({});
  const double to_m = bed.status == SampleStatus::ok ? bed.water_depth_m : layers_to_m;
  std::vector<CurrentAtDepth> currents;
  for (std::size_t i = 0; i <= current_layers; ++i) {
    const double depth_m = to_m * static_cast<double>(i) / current_layers;
    const CurrentSample current = water.forecast_current({0, 0, depth_m}, t_s);
    if (has_value(current.status)) currents.push_back({depth_m, current.velocity_m_s});
  }
  return currents;
}

void look_at_weather(const twin::EnvironmentSampler& water, double t_s, Surroundings& around) {
  const twin::Environment& environment = water.environment();
  if (const auto wind = water.free_wind({0, 0, -anemometer_m}, t_s); has_value(wind.status))
    around.wind_10m_m_s = twin::horizontal_of(wind.velocity_m_s);
  if (environment.turbines) {
    const double hub_m = environment.turbines->kind->hub_height_m;
    if (const auto wind = water.free_wind({0, 0, -hub_m}, t_s); has_value(wind.status))
      around.hub_wind_m_s = twin::horizontal_of(wind.velocity_m_s);
  }
  if (const SeaSample sea = water.sea({}, t_s); has_value(sea.status)) around.sea = sea.sea;
  if (const SeaRealisation* waves = water.waves()) around.waves_factor = waves->course().at(t_s);
  if (const CurrentSample current = water.forecast_current({}, t_s); has_value(current.status))
    around.current_m_s = current.velocity_m_s;
  around.currents = currents_of(water, t_s);
  around.visibility_m = water.visibility_m();
  around.water_visibility_m = water.water_visibility_m();
  const twin::WeatherNow* led = environment.weather ? environment.weather->now() : nullptr;
  if (led == nullptr) return;
  around.asked = led->asked;
  around.settled_s = led->settled_s;
}

/// From the vehicle that is nearest to it.
double nearest_m(std::span<const Horizontal> vehicles_m, const twin::Contact& contact) {
  const Horizontal at_m{contact.motion.position_m.y, contact.motion.position_m.x};
  double nearest = std::numeric_limits<double>::infinity();
  for (const Horizontal vehicle_m : vehicles_m)
    nearest = std::min(nearest, std::abs(at_m - vehicle_m));
  return nearest;
}

void look_at_traffic(const std::vector<twin::TrafficVessel>& vessels, double t_s,
                     std::span<const Horizontal> vehicles_m, Surroundings& around) {
  twin::TrafficPicture picture;
  twin::populate(vessels, t_s, {}, picture);
  std::vector<std::pair<double, const twin::Contact*>> by_distance;
  for (const twin::Contact& contact : picture.contacts)
    by_distance.emplace_back(nearest_m(vehicles_m, contact), &contact);
  std::stable_sort(by_distance.begin(), by_distance.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& [distance_m, contact] : by_distance) {
    if (around.vessels.size() == most_vessels) break;
    VesselNow vessel;
    vessel.mmsi = contact->id;
    vessel.east_m = contact->motion.position_m.y;
    vessel.north_m = contact->motion.position_m.x;
    vessel.velocity_m_s = {contact->motion.velocity_m_s.y, contact->motion.velocity_m_s.x};
    for (const twin::TrafficVessel& known : vessels)
      if (known.id == contact->id) {
        vessel.name = known.name;
        vessel.length_m = known.length_m;
      }
    around.vessels.push_back(std::move(vessel));
  }
  around.vessels_left_out = by_distance.size() - around.vessels.size();
}

}  // namespace

twin::SunPosition sun_at(const GeoPoint& origin, UtcTime start, double t_s) {
  return twin::sun_position(origin, start + Duration(static_cast<Duration::rep>(1000 * t_s)));
}

Surroundings surroundings_of(const RunPlace& place, double t_s,
                             std::span<const Horizontal> vehicles_m) {
  Surroundings around;
  look_at_weather(place.sampler, t_s, around);
  if (place.vessels != nullptr) look_at_traffic(*place.vessels, t_s, vehicles_m, around);
  around.sun = sun_at(place.origin, place.start, t_s);
  return around;
}

}  // namespace slackwater::people
