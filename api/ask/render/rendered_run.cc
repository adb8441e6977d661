#include "api/ask/render/rendered_run.h"

#include <algorithm>
#include <cmath>

#include "api/ask/render/logged_poses.h"
#include "api/ask/render/sensed.h"
#include "api/ask/run/scenario_run.h"
#include "api/log/command_tables.h"
#include "api/program/paths.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/sha256.h"
#include "fields/base/text.h"
#include "twin/render/scene/place_to_look_at.h"
#include "twin/render/scene/scene_of_run.h"
#include "twin/risk/sun_position.h"

namespace slackwater::api {
namespace {

/// Where the scenario says nothing of how far one sees: estimates, of fair North Sea water and of a
/// clear day.
constexpr double usual_water_m = 8, usual_air_m = 20000;

twin::Scenario scenario_of(const ingest::TrajectoryFile& log, const std::filesystem::path& path) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty())
    throw Error(ErrorKind::invalid_input,
                path.string() +
                    ": holds no scenario, so that nobody knows what there was to see; "
                    "give a log that `slackwater simulate` or `live` wrote");
  return twin::parse_scenario(yaml, path.string() + " (scenario)");
}

twin::Clarity usual_clarity(double visibility_m, twin::Medium medium) {
  twin::Clarity clarity;
  return twin::seen_through(clarity, visibility_m, medium);
}

}  // namespace

struct RenderedRun::Parts {
  RenderChoice choice;
  ingest::TrajectoryFile log;
  twin::Scenario scenario;
  LoggedPoses poses;
  ScenarioWater water;
  twin::ReadyRun ready;
  twin::RenderSensor sensor;
  twin::WaterType water_type;
  twin::Warmth warmth;
  std::size_t vehicle = 0;
  std::vector<std::optional<twin::VehicleShape>> shapes;  ///< of the log's vehicles
  std::vector<std::shared_ptr<const twin::Inspection>> inspections;
  std::vector<twin::Command> weather;  ///< in the order of their steps
  twin::Clarity in_water, in_air;
  std::vector<std::string> warnings;

  Parts(const RenderChoice& chosen, const std::filesystem::path& store_folder)
      : choice(chosen),
        log(ingest::read_trajectories(chosen.log)),
        scenario(scenario_of(log, chosen.log)),
        poses(log),
        water(water_of_log(scenario, log.attribute("forecast_sha256"), store_folder,
                           chosen.forecast)),
        sensor(twin::read_named_render_sensor(chosen.sensor, water.surround.data_folder)),
        water_type(twin::read_named_water_type(chosen.water_type, water.surround.data_folder)),
        warmth(twin::read_named_warmth(chosen.warmth, water.surround.data_folder)) {
    // Who meets whom is in the log's rows: nobody is followed or alarmed again.
    scenario.traffic = {};
    water.surround.is_only_asked = true;
    ready = twin::set_up(scenario, water.surround);
    choose_vehicle();
    read_shapes();
    gather();
    for (const twin::Command& command : commands_in(log))
      if (std::holds_alternative<twin::SetWeather>(command.what)) weather.push_back(command);
  }

  void choose_vehicle() {
    const auto named = std::find(log.names.begin(), log.names.end(), choice.vehicle);
    if (!choice.vehicle.empty() && named == log.names.end())
      throw Error(ErrorKind::not_found,
                  formatted("{}: found no vehicle {}; it has {}", choice.log.string(),
                            choice.vehicle, joined(log.names, ", ")));
    if (!choice.vehicle.empty()) {
      vehicle = static_cast<std::size_t>(named - log.names.begin());
      return;
    }
    for (std::size_t i = 0; i < log.names.size(); ++i) {
      const auto there = poses.at(i, poses.from_s());
      if (!there) continue;
      const bool is_under_water = there->position_m.z > 0;
      if (sensor.medium == twin::SensorMedium::both ||
          (sensor.medium == twin::SensorMedium::water) == is_under_water) {
        vehicle = i;
        return;
      }
    }
    throw Error(ErrorKind::not_found,
                formatted("{}: found no vehicle in {} at its start, which {} needs; name one of "
                          "{} by --vehicle",
                          choice.log.string(), twin::name_of(sensor.medium), sensor.name,
                          joined(log.names, ", ")));
  }

  void read_shapes() {
    for (std::size_t i = 0; i < log.names.size(); ++i) {
      shapes.emplace_back();
      if (i >= scenario.vehicles.size()) {
        if (i != vehicle)
          warnings.push_back(log.names[i] + " joined the run later, and is not drawn");
        continue;
      }
      shapes.back() = twin::read_vehicle_shape(
          twin::vehicle_file(scenario.vehicles[i].model, water.surround.data_folder));
    }
  }

  void gather() {
    in_water = usual_clarity(usual_water_m, twin::Medium::water);
    in_air = usual_clarity(usual_air_m, twin::Medium::air);
    const twin::Inspection* first = nullptr;
    for (const twin::Agent& agent : ready.agents) {
      if (!agent.inspection) continue;
      if (first == nullptr || agent.name == log.names[vehicle]) first = agent.inspection.get();
      // Of two that inspect one surface the first shows it.
      const bool is_new =
          std::none_of(inspections.begin(), inspections.end(), [&](const auto& other) {
            return other->plan.surfaces == agent.inspection->plan.surfaces;
          });
      if (is_new) inspections.push_back(agent.inspection);
    }
    if (first == nullptr) {
      warnings.push_back(formatted(
          "its scenario says not how far one sees: {:g} m in water and {:g} km in air are taken",
          usual_water_m, usual_air_m / 1000));
      return;
    }
    in_water = first->plan.water;
    if (first->plan.air.beam_attenuation_per_m > 0) in_air = first->plan.air;
  }
};

namespace {

/// A carriage that has the sensor at its pose: body axes along the picture's.
twin::Carriage turned_with(const twin::Pose& pose, const twin::RenderSensor& sensor) {
  const twin::Triple<double> down = cross(pose.axis, pose.right);
  const twin::Rotation<double> turned{{pose.axis.x, pose.right.x, down.x},
                                      {pose.axis.y, pose.right.y, down.y},
                                      {pose.axis.z, pose.right.z, down.z}};
  return {pose.position_m - turned.to_ned(sensor.position_m), turned, pose.velocity_m_s, {}};
}

/// The sea as somebody led it up to then.
void lead_weather(const RenderedRun::Parts& parts, double t_s) {
  const twin::Environment& environment = *parts.ready.environment;
  if (!environment.weather) return;
  environment.weather->forget();
  for (const twin::Command& command : parts.weather) {
    const double set_s = static_cast<double>(command.step) * parts.scenario.step_s;
    if (set_s <= t_s)
      environment.weather->set(std::get<twin::SetWeather>(command.what).asked, environment, set_s);
  }
}

std::vector<twin::SeenVehicle> others_at(const RenderedRun::Parts& parts, double t_s) {
  std::vector<twin::SeenVehicle> vehicles;
  for (std::size_t i = 0; i < parts.log.names.size(); ++i) {
    if (i == parts.vehicle || !parts.shapes[i]) continue;
    if (const auto there = parts.poses.at(i, t_s))
      vehicles.push_back(
          {parts.log.names[i], *parts.shapes[i], there->position_m, there->attitude});
  }
  return vehicles;
}

/// All but lamps and shadows.
twin::Lighting lighting_at(const RenderedRun::Parts& parts, const twin::EnvironmentSampler& sampler,
                           UtcTime time) {
  twin::Clarity in_water = parts.in_water, in_air = parts.in_air;
  if (const auto seen_m = sampler.water_visibility_m())
    in_water = twin::seen_through(in_water, *seen_m, twin::Medium::water);
  if (const auto seen_m = sampler.visibility_m())
    in_air = twin::seen_through(in_air, *seen_m, twin::Medium::air);
  twin::Lighting lighting;
  lighting.water = twin::coloured(in_water, parts.water_type);
  lighting.air = twin::colourless(in_air);
  lighting.seed = parts.scenario.seed;
  if (!parts.choice.is_overcast) {
    const twin::SunPosition sun = twin::sun_position(parts.ready.origin, time);
    lighting.sky = twin::clear_sky(sun.elevation_deg, sun.azimuth_deg);
  }
  return lighting;
}

/// Of the sun, at right angles to it, W/m2; 0 by night and under cloud.
double sun_beam_w_m2(const RenderedRun::Parts& parts, UtcTime time) {
  if (parts.choice.is_overcast) return 0;
  const double elevation_deg = twin::sun_position(parts.ready.origin, time).elevation_deg;
  return elevation_deg > 0
             ? twin::clear_beam_w_m2(elevation_deg) / std::sin(elevation_deg * constants::degree)
             : 0;
}

}  // namespace

RenderedRun::RenderedRun(const RenderChoice& choice, const std::filesystem::path& store_folder)
    : parts_(std::make_unique<Parts>(choice, store_folder)) {}
RenderedRun::~RenderedRun() = default;

const twin::RenderSensor& RenderedRun::sensor() const noexcept { return parts_->sensor; }
const std::string& RenderedRun::vehicle() const noexcept {
  return parts_->log.names[parts_->vehicle];
}
const std::string& RenderedRun::title() const noexcept { return parts_->scenario.name; }
GeoPoint RenderedRun::origin() const noexcept { return parts_->ready.origin; }
UtcTime RenderedRun::start() const noexcept { return parts_->ready.start; }
double RenderedRun::from_s() const noexcept { return parts_->poses.from_s(); }
double RenderedRun::to_s() const noexcept { return parts_->poses.to_s(); }
const std::vector<std::string>& RenderedRun::warnings() const noexcept { return parts_->warnings; }

RenderView RenderedRun::view_at(double t_s) const {
  const Parts& parts = *parts_;
  const twin::RenderSensor& sensor = parts.sensor;
  if (!(t_s >= from_s() && t_s <= to_s()))
    throw Error(
        ErrorKind::invalid_input,
        formatted("found {:g} s, expected a time of the run, {:g} to {:g} s after its start", t_s,
                  from_s(), to_s()));
  const auto carriage = parts.poses.at(parts.vehicle, t_s);
  if (!carriage)
    throw Error(ErrorKind::invalid_input,
                formatted("{} was not there at {:g} s: it joined later, or had come to grief",
                          vehicle(), t_s));
  lead_weather(parts, t_s);
  const twin::EnvironmentSampler sampler(*parts.ready.environment);

  RenderView view;
  view.t_s = t_s;
  view.time = parts.ready.start + std::chrono::milliseconds(std::llround(1000 * t_s));
  view.pose = twin::pose_of(sensor, *carriage);
  // Lamps stand on the hull, or turn with the camera that is turned.
  twin::Carriage lamps_on = *carriage;
  if (sensor.is_aimed) {
    const auto place_m =
        twin::place_to_look_at(parts.inspections, parts.ready.environment->structures,
                               view.pose.position_m, sensor.most_range_m);
    if (place_m) {
      view.pose = twin::pose_of(sensor, *carriage, *place_m);
      lamps_on = turned_with(view.pose, sensor);
    }
  }
  const std::vector<twin::SeenVehicle> vehicles = others_at(parts, t_s);
  const twin::RenderScene scene =
      twin::scene_of_run({sampler, parts.inspections, vehicles, parts.scenario.seed, t_s,
                          view.pose.position_m, sensor.most_range_m});
  const bool is_under_water = view.pose.position_m.z > scene.surface_m;
  twin::expect_in_medium(sensor, is_under_water,
                         formatted("{:.2f} m {} the surface, {:g} s after the start",
                                   std::abs(view.pose.position_m.z - scene.surface_m),
                                   is_under_water ? "below" : "above", t_s));
  for (const twin::SeenThing& thing : scene.things)
    view.things.push_back({thing.name, thing.seen_class});
  for (const twin::DefectMark& mark : scene.marks)
    view.defects.push_back({mark.defect, mark.kind, scene.things[mark.thing].name, mark.thing + 1U,
                            2 * mark.half_along_m, mark.severity, mark.centre_m, 0});

  // Noise of its own for each moment.
  const auto seed = parts.scenario.seed ^ static_cast<std::uint64_t>(std::llround(1000 * t_s));
  const twin::Lighting lighting = lighting_at(parts, sampler, view.time);
  const SensorThere there{sensor,
                          scene,
                          sampler,
                          lighting,
                          parts.warmth,
                          view.pose,
                          lamps_on,
                          sun_beam_w_m2(parts, view.time),
                          parts.choice.is_overcast,
                          seed,
                          parts.choice.threads};
  view.seen = sensed(there);
  count_defects(view);
  return view;
}

}  // namespace slackwater::api
