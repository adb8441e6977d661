#pragma once
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/light/smooth_normals.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A place that a pixel shows.
struct SeenPlace {
  const SeenThing& thing;
  Triple<double> at_m;    ///< NED of the run
  Triple<double> face;    ///< unit, normal of its triangle, towards the camera
  Triple<double> normal;  ///< the same rounded off, not turned away from the camera either
  const DefectMark* mark = nullptr;  ///< that holds it, of several the later one; null: none
};

/// Tells what pixels show of a scene, made ready once. Const calls from any threads.
class SeenPlaces {
 public:
  /// @param scene  outlives it
  explicit SeenPlaces(const RenderScene& scene);

  /// @param ray    of the pixel
  /// @param pixel  that meets something
  [[nodiscard]] SeenPlace at(const Ray& ray, const FrameHits& hits, std::size_t pixel) const;

 private:
  const RenderScene& scene_;
  std::vector<SmoothNormals> normals_;                 // of each thing
  std::vector<std::vector<const DefectMark*>> marks_;  // of each thing
};

}  // namespace slackwater::twin
