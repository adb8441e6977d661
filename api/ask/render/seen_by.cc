#include "api/ask/render/seen_by.h"

#include <limits>

#include "twin/render/sheet/camera_light.h"

namespace slackwater::api {
namespace {

std::vector<twin::TriangleMesh> meshes_of(const twin::RenderScene& scene) {
  std::vector<twin::TriangleMesh> meshes;
  for (const twin::SeenThing& thing : scene.things) meshes.push_back(thing.mesh);
  return meshes;
}

/// What the left camera of a pair saw.
struct LeftView {
  const twin::Pinhole& camera;
  const twin::TruthFrame& truth;
  const twin::FrameHits& hits;
};

RightView right_of_pair(const twin::CameraThere& left_there, double most_range_m,
                        const LeftView& left) {
  const twin::CameraSheet& sheet = left_there.sheet;
  const int threads = left_there.threads;
  RightView right;
  right.baseline_m = sheet.baseline_m;
  right.truth = twin::stereo_truth(left.camera, left.truth, left.hits, sheet.baseline_m,
                                   twin::RayCaster(meshes_of(left_there.scene)), threads);
  twin::CameraThere there = left_there;
  there.pose = twin::right_of(left_there.pose, sheet.baseline_m);
  there.seed = ~left_there.seed;
  const twin::Pinhole camera(there.pose, sheet.frame);
  twin::FrameHits hits;
  twin::find_hits_of(there.scene, camera, most_range_m, threads, hits);
  right.picture =
      twin::developed(twin::light_in(there, camera, hits).frame, sheet.sensor, there.seed, threads);
  return right;
}

/// By device.
class Looker {
 public:
  explicit Looker(const BeforeSensor& before) : before_(before) {}

  SeenByDevice operator()(const twin::CameraSheet& sheet) const {
    twin::Lighting lighting = before_.lighting;
    for (const twin::MountedLamp& lamp : sheet.lamps)
      lighting.lamps.push_back(twin::lamp_of(lamp, before_.lamps_on));
    lighting.shadows = twin::shadows_of(before_.scene);
    const twin::Pinhole camera(before_.pose, sheet.frame);
    const twin::CameraThere there{sheet,        before_.scene, lighting,
                                  before_.pose, before_.seed,  before_.threads};
    CameraView seen;
    seen.matrix = camera.matrix();
    twin::FrameHits hits;
    seen.truth =
        twin::truth_of(before_.scene, camera, before_.sensor.most_range_m, before_.threads, hits);
    const twin::CameraLight light = twin::light_in(there, camera, hits);
    seen.flakes = light.flakes;
    seen.drops = light.drops;
    seen.picture = twin::developed(light.frame, sheet.sensor, before_.seed, before_.threads);
    if (sheet.baseline_m > 0)
      seen.right = right_of_pair(there, before_.sensor.most_range_m, {camera, seen.truth, hits});
    return seen;
  }
  SeenByDevice operator()(const twin::InfraredSheet& sheet) const {
    const twin::Pinhole camera(before_.pose, sheet.frame);
    InfraredView seen;
    seen.matrix = camera.matrix();
    twin::FrameHits hits;
    seen.truth =
        twin::truth_of(before_.scene, camera, before_.sensor.most_range_m, before_.threads, hits);
    const twin::Shadows shadows = twin::shadows_of(before_.scene);
    const twin::InfraredLight light{before_.warmth,      before_.lighting.sky, before_.beam_w_m2,
                                    before_.is_overcast, air_attenuation(),    shadows};
    seen.heat = twin::infrared_of(before_.scene, light, sheet.sensor, camera, hits, before_.seed,
                                  before_.threads);
    return seen;
  }
  SeenByDevice operator()(const twin::LidarSheet& sheet) const {
    return twin::scanned(before_.scene, caster(), sheet, before_.pose, least_m(), most_m(),
                         air_attenuation(), before_.seed, before_.threads);
  }
  SeenByDevice operator()(const twin::ImagingSonarSheet& sheet) const {
    return twin::pinged(before_.scene, caster(), sheet, before_.pose, least_m(), most_m(),
                        before_.seed, before_.threads);
  }
  SeenByDevice operator()(const twin::SideScanSheet& sheet) const {
    return twin::side_scanned(before_.scene, caster(), sheet, before_.pose, least_m(), most_m(),
                              before_.seed, before_.threads);
  }
  SeenByDevice operator()(const twin::MultibeamSheet& sheet) const {
    return MultibeamView{twin::sounded(before_.scene, caster(), sheet, before_.pose, least_m(),
                                       most_m(), before_.seed, before_.threads)};
  }
  SeenByDevice operator()(const twin::EchoSounderSheet& sheet) const {
    return twin::echo_sounded(before_.scene, caster(), sheet, before_.pose, least_m(), most_m(),
                              before_.seed, before_.threads);
  }
  SeenByDevice operator()(const twin::Adcp& sheet) const {
    return twin::profiled(caster(), sheet, water_now(), before_.pose, most_m(), before_.seed);
  }

 private:
  [[nodiscard]] twin::RayCaster caster() const { return twin::RayCaster(meshes_of(before_.scene)); }
  [[nodiscard]] double least_m() const { return before_.sensor.least_range_m; }
  [[nodiscard]] double most_m() const { return before_.sensor.most_range_m; }
  [[nodiscard]] double air_attenuation() const {
    return before_.lighting.air.beam_attenuation_per_m[twin::green];
  }
  /// The run's own current and waves; NaN in air, and where nobody knows the water.
  [[nodiscard]] twin::WaterAt water_now() const {
    return [this](const twin::Triple<double>& at_m) -> twin::Triple<double> {
      constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
      const twin::WaterSample water = before_.sampler.water(at_m, 0, before_.scene.t_s);
      if (!has_value(water.status) || at_m.z < -water.motion.elevation_m)
        return {unknown, unknown, unknown};
      return water.motion.velocity_m_s;
    };
  }

  const BeforeSensor& before_;
};

}  // namespace

SeenByDevice seen_by(const BeforeSensor& before) {
  return std::visit(Looker(before), before.sensor.device);
}

}  // namespace slackwater::api
