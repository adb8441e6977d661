#include "api/ask/render/sensed.h"

#include <limits>

#include "twin/render/light/light_frame.h"

namespace slackwater::api {
namespace {

std::vector<twin::TriangleMesh> meshes_of(const twin::RenderScene& scene) {
  std::vector<twin::TriangleMesh> meshes;
  for (const twin::SeenThing& thing : scene.things) meshes.push_back(thing.mesh);
  return meshes;
}

/// What a pinhole sees, and its truth.
struct SeenFrame {
  twin::Pinhole camera;
  twin::FrameHits hits;
  twin::TruthFrame truth;

  SeenFrame(const SensorThere& there, const twin::FrameFootprint& frame, const twin::Pose& pose)
      : camera(pose, frame),
        truth(twin::truth_of(there.scene, camera, there.sensor.most_range_m, there.threads, hits)) {
  }
};

/// A picture: the light that comes, with flakes before it, blurred by the water and by what moves.
twin::Picture picture_of(const SensorThere& there, const twin::CameraSheet& sheet,
                         const twin::Lighting& lighting, const twin::Pose& pose,
                         const SeenFrame& frame, std::uint64_t seed, std::size_t& flakes) {
  const bool is_under_water = pose.position_m.z > there.scene.surface_m;
  twin::LightFrame light =
      twin::light_of(there.scene, lighting, frame.camera, frame.hits, there.threads);
  if (sheet.marine_snow && is_under_water) {
    const auto all = twin::flakes_in_view(*sheet.marine_snow, frame.camera, seed);
    flakes = all.size();
    light = twin::with_flakes(light, all, *sheet.marine_snow, lighting, there.scene.surface_m,
                              frame.camera, frame.hits);
  }
  if (sheet.forward_scatter && is_under_water)
    light =
        twin::scattered_forwards(light, *sheet.forward_scatter, frame.camera, frame.hits,
                                 lighting.water.beam_attenuation_per_m[twin::green], there.threads);
  if (sheet.shutter)
    light =
        twin::through_shutter(light, *sheet.shutter, frame.camera, pose, frame.hits, there.threads);
  return twin::developed(light, sheet.sensor, seed, there.threads);
}

RightView seen_by_right(const SensorThere& there, const twin::CameraSheet& sheet,
                        const twin::Lighting& lighting, const SeenFrame& left) {
  RightView right;
  right.baseline_m = sheet.baseline_m;
  right.truth = twin::stereo_truth(left.camera, left.truth, left.hits, sheet.baseline_m,
                                   twin::RayCaster(meshes_of(there.scene)), there.threads);
  const twin::Pose pose = twin::right_of(there.pose, sheet.baseline_m);
  const SeenFrame frame(there, sheet.frame, pose);
  std::size_t flakes = 0;
  right.picture = picture_of(there, sheet, lighting, pose, frame, ~there.seed, flakes);
  return right;
}

Seen seen_by(const twin::CameraSheet& sheet, const SensorThere& there) {
  twin::Lighting lighting = there.lighting;
  for (const twin::MountedLamp& lamp : sheet.lamps)
    lighting.lamps.push_back(twin::lamp_of(lamp, there.lamps_on));
  lighting.shadows = twin::shadows_of(there.scene);
  SeenFrame frame(there, sheet.frame, there.pose);
  CameraView seen;
  seen.matrix = frame.camera.matrix();
  seen.picture = picture_of(there, sheet, lighting, there.pose, frame, there.seed, seen.flakes);
  if (sheet.baseline_m > 0) seen.right = seen_by_right(there, sheet, lighting, frame);
  seen.truth = std::move(frame.truth);
  return seen;
}

Seen seen_by(const twin::InfraredSheet& sheet, const SensorThere& there) {
  SeenFrame frame(there, sheet.frame, there.pose);
  const twin::Shadows shadows = twin::shadows_of(there.scene);
  const twin::InfraredLight light{there.warmth,
                                  there.lighting.sky,
                                  there.sun_beam_w_m2,
                                  there.is_overcast,
                                  there.lighting.air.beam_attenuation_per_m[twin::green],
                                  shadows};
  InfraredView seen;
  seen.matrix = frame.camera.matrix();
  seen.heat = twin::infrared_of(there.scene, light, sheet.sensor, frame.camera, frame.hits,
                                there.seed, there.threads);
  seen.truth = std::move(frame.truth);
  return seen;
}

/// The run's own current and waves; NaN in air, and where nobody knows the water.
twin::WaterAt water_about(const SensorThere& there) {
  return [&there](const twin::Triple<double>& at_m) -> twin::Triple<double> {
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const twin::WaterSample water = there.sampler.water(at_m, 0, there.scene.t_s);
    if (!has_value(water.status) || at_m.z < -water.motion.elevation_m)
      return {unknown, unknown, unknown};
    return water.motion.velocity_m_s;
  };
}

/// What measures ranges: with rays at the scene.
template <typename Sheet>
Seen seen_by(const Sheet& sheet, const SensorThere& there) {
  const twin::RayCaster caster(meshes_of(there.scene));
  const double least_m = there.sensor.least_range_m, most_m = there.sensor.most_range_m;
  const auto by = [&](const auto& ping) {
    return ping(there.scene, caster, sheet, there.pose, least_m, most_m, there.seed, there.threads);
  };
  if constexpr (std::is_same_v<Sheet, twin::LidarSheet>)
    return twin::scanned(there.scene, caster, sheet, there.pose, least_m, most_m,
                         there.lighting.air.beam_attenuation_per_m[twin::green], there.seed,
                         there.threads);
  else if constexpr (std::is_same_v<Sheet, twin::Adcp>)
    return twin::profiled(caster, sheet, water_about(there), there.pose, most_m, there.seed);
  else if constexpr (std::is_same_v<Sheet, twin::ImagingSonarSheet>)
    return by(twin::pinged);
  else if constexpr (std::is_same_v<Sheet, twin::SideScanSheet>)
    return by(twin::side_scanned);
  else if constexpr (std::is_same_v<Sheet, twin::MultibeamSheet>)
    return MultibeamView{by(twin::sounded)};
  else
    return by(twin::echo_sounded);
}

}  // namespace

Seen sensed(const SensorThere& there) {
  return std::visit([&](const auto& sheet) { return seen_by(sheet, there); }, there.sensor.device);
}

void count_defects(RenderView& view) {
  const auto* camera = std::get_if<CameraView>(&view.seen);
  const auto* infrared = std::get_if<InfraredView>(&view.seen);
  if (camera == nullptr && infrared == nullptr) return;
  for (const std::uint16_t defect : (camera != nullptr ? camera->truth : infrared->truth).defect)
    if (defect > 0) ++view.defects[defect - 1U].pixels;
}

}  // namespace slackwater::api
