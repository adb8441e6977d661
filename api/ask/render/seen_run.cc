#include "api/ask/render/seen_run.h"

#include <algorithm>
#include <cmath>

#include "api/ask/render/seen_by.h"
#include "api/ask/render/seen_tethers.h"
#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/instrument/pointing.h"
#include "twin/render/light/sun_glint.h"
#include "twin/render/scene/place_to_look_at.h"
#include "twin/render/scene/scene_of_run.h"
#include "twin/risk/workability/sun_position.h"

namespace slackwater::api {
namespace {

/// Where the scenario says nothing of how far one sees: estimates, of fair North Sea water and of a
/// clear day.
constexpr double usual_water_m = 8, usual_air_m = 20000;

twin::Clarity usual_clarity(double visibility_m, twin::Medium medium) {
  twin::Clarity clarity;
  return twin::seen_through(clarity, visibility_m, medium);
}

twin::ReadyRun ready_to_look_at(const twin::Scenario& scenario, twin::Surround surround) {
  surround.is_only_asked = true;
  return twin::set_up(scenario, surround);
}

/// Of a clear sky's sun, at right angles to it, W/m2; 0 by night.
double beam_across_w_m2(double elevation_deg) {
  return elevation_deg > 0
             ? twin::clear_beam_w_m2(elevation_deg) / std::sin(elevation_deg * constants::degree)
             : 0;
}

std::span<const std::uint16_t> defects_shown(const SeenByDevice& seen) {
  if (const auto* camera = std::get_if<CameraView>(&seen)) return camera->truth.defect;
  if (const auto* infrared = std::get_if<InfraredView>(&seen)) return infrared->truth.defect;
  return {};
}

/// Of a camera, of light or of heat; else null. @param sensor  a RenderSensor, const or not
template <typename Sensor>
auto* frame_of(Sensor& sensor) noexcept {
  auto* camera = std::get_if<twin::CameraSheet>(&sensor.device);
  if (camera != nullptr) return &camera->frame;
  auto* heat = std::get_if<twin::InfraredSheet>(&sensor.device);
  return heat != nullptr ? &heat->frame : nullptr;
}

}  // namespace

bool changes_the_view(const twin::Command& command) noexcept {
  return std::holds_alternative<twin::SetWeather>(command.what) ||
         std::holds_alternative<twin::PointCamera>(command.what) ||
         std::holds_alternative<twin::Resume>(command.what);
}

MountedSensor mounted_sensor(const std::string& sensor, std::size_t vehicle,
                             const SightChoice& sight, const std::filesystem::path& data_folder) {
  return {twin::read_named_render_sensor(sensor, data_folder),
          vehicle,
          twin::read_named_water_type(sight.water_type, data_folder),
          twin::read_named_warmth(sight.warmth, data_folder),
          sight.is_overcast,
          1};
}

SeenRun::SeenRun(twin::Scenario scenario, const twin::Surround& surround,
                 std::vector<std::string> vehicles)
    : scenario_(std::move(scenario)),
      names_(std::move(vehicles)),
      ready_(ready_to_look_at(scenario_, surround)),
      shapes_(names_.size()) {
  for (std::size_t i = 0; i < std::min(names_.size(), scenario_.vehicles.size()); ++i)
    shapes_[i] = twin::read_vehicle_shape(
        twin::vehicle_file(scenario_.vehicles[i].model, surround.data_folder));
  for (const twin::Agent& agent : ready_.agents) {
    if (!agent.inspection) continue;
    // Of two that inspect one surface the first shows it.
    const bool is_new = std::none_of(
        inspections_.begin(), inspections_.end(),
        [&](const auto& other) { return other->plan.surfaces == agent.inspection->plan.surfaces; });
    if (is_new) inspections_.push_back(agent.inspection);
  }
}

/// That of the vehicle's own inspection, else of the first one.
SeenRun::Sight SeenRun::sight_from(std::size_t vehicle) const {
  Sight sight{usual_clarity(usual_water_m, twin::Medium::water),
              usual_clarity(usual_air_m, twin::Medium::air), false};
  const twin::Inspection* of = nullptr;
  for (const twin::Agent& agent : ready_.agents)
    if (agent.inspection && (of == nullptr || agent.name == names_[vehicle]))
      of = agent.inspection.get();
  if (of == nullptr) return sight;
  sight.is_stated = true;
  sight.in_water = of->plan.water;
  if (of->plan.air.beam_attenuation_per_m > 0) sight.in_air = of->plan.air;
  return sight;
}

std::vector<std::string> SeenRun::warnings(std::size_t vehicle) const {
  std::vector<std::string> warnings;
  for (std::size_t i = scenario_.vehicles.size(); i < names_.size(); ++i)
    if (i != vehicle) warnings.push_back(names_[i] + " joined the run later, and is not drawn");
  if (!sight_from(vehicle).is_stated)
    warnings.push_back(formatted(
        "its scenario says not how far one sees: {:g} m in water and {:g} km in air are taken",
        usual_water_m, usual_air_m / 1000));
  return warnings;
}

/// The sea as somebody led it up to then.
void SeenRun::lead_weather(const SeenMoment& moment) const {
  const twin::Environment& environment = *ready_.environment;
  if (!environment.weather) return;
  environment.weather->forget();
  for (const twin::Command& command : moment.commands) {
    const auto* weather = std::get_if<twin::SetWeather>(&command.what);
    const double set_s = static_cast<double>(command.step) * scenario_.step_s;
    if (weather != nullptr && set_s <= moment.t_s)
      environment.weather->set(weather->asked, environment, set_s);
  }
}

/// As somebody left the joints of its vehicle's cameras by then.
twin::CameraPointing SeenRun::pointing(const MountedSensor& mounted,
                                       const SeenMoment& moment) const {
  twin::CameraPointing pointing;
  if (frame_of(mounted.sensor) == nullptr) return pointing;
  for (const twin::Command& command : moment.commands) {
    const bool is_by_then = static_cast<double>(command.step) * scenario_.step_s <= moment.t_s;
    if (command.agent != mounted.vehicle || !is_by_then) continue;
    if (const auto* turned = std::get_if<twin::PointCamera>(&command.what))
      pointing = turned->pointing;
    else if (std::holds_alternative<twin::Resume>(command.what))
      pointing = {};
  }
  return pointing;
}

std::vector<twin::SeenVehicle> SeenRun::others_than(std::size_t vehicle,
                                                    const SeenMoment& moment) const {
  std::vector<twin::SeenVehicle> vehicles;
  for (std::size_t i = 0; i < names_.size(); ++i) {
    if (i == vehicle || !shapes_[i]) continue;
    if (const auto& there = moment.vehicles[i])
      vehicles.push_back({names_[i], *shapes_[i], there->position_m, there->attitude});
  }
  return vehicles;
}

/// All but lamps and shadows.
twin::Lighting SeenRun::lighting(const MountedSensor& mounted, const SeenMoment& moment,
                                 const twin::EnvironmentSampler& sampler, UtcTime time) const {
  Sight sight = sight_from(mounted.vehicle);
  if (const auto seen_m = sampler.water_visibility_m())
    sight.in_water = twin::seen_through(sight.in_water, *seen_m, twin::Medium::water);
  if (const auto seen_m = sampler.visibility_m())
    sight.in_air = twin::seen_through(sight.in_air, *seen_m, twin::Medium::air);
  twin::Lighting lighting;
  lighting.water = twin::coloured(sight.in_water, mounted.water_type);
  lighting.air = twin::colourless(sight.in_air);
  lighting.seed = scenario_.seed;
  const twin::Triple<double>& at_m = moment.vehicles[mounted.vehicle]->position_m;
  const auto wind = sampler.free_wind({at_m.x, at_m.y, -12.5}, moment.t_s);
  if (has_value(wind.status))
    lighting.sea_slope =
        twin::mean_square_slope(std::hypot(wind.velocity_m_s.x, wind.velocity_m_s.y));
  if (!mounted.is_overcast) {
    const twin::SunPosition sun = twin::sun_position(ready_.origin, time);
    lighting.sky = twin::clear_sky(sun.elevation_deg, sun.azimuth_deg);
  }
  return lighting;
}

SeenRun::Sighting SeenRun::sighting(const MountedSensor& mounted, const SeenMoment& moment,
                                    const twin::EnvironmentSampler& sampler) const {
  expects(moment.vehicles.size() == names_.size(), "a moment has a place for each vehicle");
  expects(moment.vehicles[mounted.vehicle].has_value(), "the vehicle of a sensor is there");
  const twin::RenderSensor& sensor = mounted.sensor;
  const twin::Carriage& carriage = *moment.vehicles[mounted.vehicle];
  // Lamps stand on the hull, or turn with the camera that is turned.
  Sighting sighting{twin::pose_of(sensor, carriage), carriage, {}};
  const twin::CameraPointing pointing = this->pointing(mounted, moment);
  if (pointing.pan_rad != 0 || pointing.tilt_rad != 0) {
    sighting.pose = twin::pointed(sighting.pose, carriage, pointing);
    sighting.lamps_on = twin::hull_that_has(sensor, sighting.pose);
  } else if (sensor.is_aimed) {
    const auto place_m = twin::place_to_look_at(inspections_, ready_.environment->structures,
                                                sighting.pose.position_m, sensor.most_range_m);
    if (place_m) {
      sighting.pose = twin::pose_of(sensor, carriage, *place_m);
      sighting.lamps_on = twin::hull_that_has(sensor, sighting.pose);
    }
  }
  const std::vector<twin::SeenVehicle> vehicles = others_than(mounted.vehicle, moment);
  const std::vector<twin::SeenTether> tethers =
      seen_tethers(ready_, scenario_, moment.vehicles, moment.t_s);
  sighting.scene =
      twin::scene_of_run({sampler, inspections_, vehicles, tethers, ready_.vessels, scenario_.seed,
                          moment.t_s, sighting.pose.position_m, sensor.most_range_m});
  const double below_m = sighting.pose.position_m.z - sighting.scene.surface_m;
  twin::expect_in_medium(sensor, below_m > 0,
                         formatted("{:.2f} m {} the surface, {:g} s after the start",
                                   std::abs(below_m), below_m > 0 ? "below" : "above", moment.t_s));
  return sighting;
}

void SeenRun::expect_sees(const MountedSensor& mounted, const SeenMoment& moment) const {
  lead_weather(moment);
  (void)sighting(mounted, moment, twin::EnvironmentSampler(*ready_.environment));
}

RenderView SeenRun::look(const MountedSensor& mounted, const SeenMoment& moment) const {
  twin::RenderSensor sensor = mounted.sensor;
  if (const double zoom = pointing(mounted, moment).zoom; zoom != 1)
    twin::zoom_in(zoom, *frame_of(sensor));
  const double t_s = moment.t_s;
  lead_weather(moment);
  const twin::EnvironmentSampler sampler(*ready_.environment);
  const auto [pose, lamps_on, scene] = sighting(mounted, moment, sampler);

  RenderView view;
  view.t_s = t_s;
  view.time = ready_.start + std::chrono::milliseconds(std::llround(1000 * t_s));
  view.pose = pose;
  for (const twin::SeenThing& thing : scene.things)
    view.things.push_back({thing.name, thing.seen_class});
  for (const twin::DefectMark& mark : scene.marks)
    view.defects.push_back({mark.defect, mark.kind, scene.things[mark.thing].name, mark.thing + 1U,
                            2 * mark.half_along_m, mark.severity, mark.centre_m, 0});

  // Noise of its own for each moment.
  const auto seed = scenario_.seed ^ static_cast<std::uint64_t>(std::llround(1000 * t_s));
  const twin::Lighting light = lighting(mounted, moment, sampler, view.time);
  const double beam_w_m2 =
      mounted.is_overcast
          ? 0
          : beam_across_w_m2(twin::sun_position(ready_.origin, view.time).elevation_deg);
  view.seen = seen_by({sensor, scene, view.pose, lamps_on, light, mounted.warmth, beam_w_m2,
                       mounted.is_overcast, sampler, seed, mounted.threads});
  for (const std::uint16_t defect : defects_shown(view.seen))
    if (defect > 0) ++view.defects[defect - 1U].pixels;
  return view;
}

}  // namespace slackwater::api
