#pragma once
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/frame/pinhole.h"
#include "twin/render/light/smooth_normals.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A place that a pixel shows.
struct SeenPlace {
  const SeenThing& thing;
  Triple<double> at_m;    ///< NED of the run
  Triple<double> face;    ///< unit, normal of its triangle, towards the camera
  Triple<double> normal;  ///< the same rounded off, not turned away from the camera either
  /// That covers most of the pixel, of several the later one; null: none.
  const DefectMark* mark = nullptr;
  double mark_share = 0;  ///< of the pixel that it covers (mark_share.h)

  /// Of a pixel that shows one thing: the mark where it covers half of it.
  [[nodiscard]] const DefectMark* mostly() const noexcept {
    return mark_share >= 0.5 ? mark : nullptr;
  }
};

/// Tells what pixels show of a scene, made ready once. Const calls from any threads.
class SeenPlaces {
 public:
  /// @param scene, camera  outlive it
  SeenPlaces(const RenderScene& scene, const Pinhole& camera);

  /// @param ray    of the pixel
  /// @param pixel  that meets something
  [[nodiscard]] SeenPlace at(const Ray& ray, const FrameHits& hits, std::size_t pixel) const;

 private:
  const RenderScene& scene_;
  const Pinhole& camera_;
  std::vector<SmoothNormals> normals_;                 // of each thing
  std::vector<std::vector<const DefectMark*>> marks_;  // of each thing
};

}  // namespace slackwater::twin
