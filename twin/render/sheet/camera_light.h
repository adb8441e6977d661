#pragma once
#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/light_frame.h"
#include "twin/render/sheet/render_sensor.h"

namespace slackwater::twin {

/// A camera where it looks.
struct CameraThere {
  const CameraSheet& sheet;
  const RenderScene& scene;
  const Lighting& lighting;  ///< with its lamps
  Pose pose;
  std::uint64_t seed = 0;  ///< of flakes and drops
  int threads = 1;
};

/// What falls on a camera's sensor.
struct CameraLight {
  LightFrame frame;
  std::size_t flakes = 0;  ///< of marine snow, in view or behind something
  std::size_t drops = 0;   ///< of spray, likewise
};

/// The light of a scene (`light_of`), and what its sheet has of, in this order: blur by the water's
/// forward scatter, marine snow (flakes are near, and not blurred as what lies behind them) or
/// spray, smear by what moves. What is of water is left out in air, spray in water.
[[nodiscard]] CameraLight light_in(const CameraThere& there, const Pinhole& camera,
                                   const FrameHits& hits);
/// What becomes of the scene's light on its way into the camera: the second half of it.
[[nodiscard]] CameraLight light_behind_lens(LightFrame of_scene, const CameraThere& there,
                                            const Pinhole& camera, const FrameHits& hits);

}  // namespace slackwater::twin
