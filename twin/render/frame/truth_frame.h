#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "twin/render/frame/frame_hits.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// What a picture shows, as it is: row by row, one value a pixel, of its middle. Single precision
/// of numbers worked out in double.
struct TruthFrame {
  int wide = 0;
  int high = 0;
  std::vector<float> range_m;           ///< along the ray; NaN: nothing within reach
  std::vector<float> depth_m;           ///< along the camera's axis; NaN likewise
  std::vector<std::uint16_t> instance;  ///< 1 + the thing's place in the scene; 0: nothing
  std::vector<SeenClass> seen_class;
  std::vector<std::uint16_t> defect;  ///< 1 + the place of its mark in the scene; 0: none
  /// Unit, to the right, down and along the axis, towards the camera; zeros: nothing.
  std::vector<std::array<float, 3>> normal;
  /// Where what is seen is at the other moment, less where it is now, in pixels to the right and
  /// down; NaN where it is behind the camera by then. Empty: no other moment was given.
  std::vector<std::array<float, 2>> flow;

  [[nodiscard]] std::size_t pixels() const noexcept { return range_m.size(); }
};

/// A scene and a camera at another moment. Its things are those of the first one, in their order
/// and with the triangles of each.
struct OtherMoment {
  const RenderScene& scene;
  const Pinhole& camera;
};

/// What each pixel meets first of a scene (`find_first_hits`).
void find_hits_of(const RenderScene& scene, const Pinhole& camera, double most_range_m, int threads,
                  FrameHits& hits);

/// The truth of a picture. A pixel shows a defect where the place that it meets is held by its mark
/// (render_scene.h): of two the later one.
///
/// Flow is that of the material: the place keeps its weights of its triangle's corners. It says
/// nothing of what stands in the way at the other moment.
///
/// The same bits on any number of threads.
/// @param hits  scratch; then those of the picture
[[nodiscard]] TruthFrame truth_of(const RenderScene& scene, const Pinhole& camera,
                                  double most_range_m, int threads, FrameHits& hits,
                                  const OtherMoment* other = nullptr);

}  // namespace slackwater::twin
