#pragma once
#include <string>
#include <vector>

#include "tests/twin/inspection/surface/surface_for_tests.h"

namespace slackwater::tests {

/// A monopile in 35 m of water with its transition piece and anodes, at north 0, east 0, in about
/// 50 000 triangles: what rays are cast at in proofs of speed.
/// @param patch_m  of the pile; the default makes 50 000 triangles within 5 %
inline std::vector<twin::Surface> foundation_for_tests(double patch_m = 0.25) {
  std::vector<twin::Surface> surfaces;
  surfaces.push_back(
      surface_of("kind: monopile, name: A01/monopile, north_m: 0, east_m: 0, radius_m: 3, from: "
                 "{height_m: 0}, to: {depth_m: 35}",
                 patch_m));
  surfaces.push_back(
      surface_of("kind: transition_piece, name: A01/transition_piece, north_m: 0, east_m: 0, "
                 "radius_m: 3.2, from: {height_m: 20}, to: {depth_m: 3}, landing_deg: 180",
                 patch_m));
  surfaces.push_back(
      surface_of("kind: anodes, name: A01/anodes, north_m: 0, east_m: 0, radius_m: 3, from: "
                 "{depth_m: 4}, to: {depth_m: 33}, bars: 8",
                 patch_m));
  return surfaces;
}

inline std::size_t triangles_of(const std::vector<twin::Surface>& surfaces) {
  std::size_t triangles = 0;
  for (const twin::Surface& surface : surfaces) triangles += surface.mesh.triangles.size();
  return triangles;
}

}  // namespace slackwater::tests
