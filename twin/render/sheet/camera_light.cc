#include "twin/render/sheet/camera_light.h"

#include <utility>

#include "twin/render/lens/spray.h"

namespace slackwater::twin {

CameraLight light_in(const CameraThere& there, const Pinhole& camera, const FrameHits& hits) {
  return light_behind_lens(light_of(there.scene, there.lighting, camera, hits, there.threads),
                           there, camera, hits);
}

CameraLight light_behind_lens(LightFrame of_scene, const CameraThere& there, const Pinhole& camera,
                              const FrameHits& hits) {
  const CameraSheet& sheet = there.sheet;
  const bool is_under_water = there.pose.position_m.z > there.scene.surface_m;
  CameraLight seen;
  seen.frame = std::move(of_scene);
  if (sheet.forward_scatter && is_under_water)
    seen.frame =
        scattered_forwards(seen.frame, *sheet.forward_scatter, camera, hits,
                           there.lighting.water.beam_attenuation_per_m[green], there.threads);
  if (sheet.marine_snow && is_under_water) {
    const auto all = flakes_in_view(*sheet.marine_snow, camera, there.seed);
    seen.flakes = all.size();
    seen.frame = with_flakes(seen.frame, all, *sheet.marine_snow, there.lighting,
                             there.scene.surface_m, camera, hits);
  }
  if (sheet.spray && !is_under_water) {
    const auto all = drops_in_view(*sheet.spray, camera, there.seed);
    seen.drops = all.size();
    seen.frame = with_drops(seen.frame, all, *sheet.spray, there.lighting, there.scene.surface_m,
                            camera, hits);
  }
  if (sheet.shutter)
    seen.frame =
        through_shutter(seen.frame, *sheet.shutter, camera, there.pose, hits, there.threads);
  return seen;
}

}  // namespace slackwater::twin
