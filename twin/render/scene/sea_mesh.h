#pragma once
#include "fields/wave/sea_realisation.h"
#include "twin/inspection/surface/triangle_mesh.h"

namespace slackwater::twin {

/// The surface of the sea about a place as triangles that face up: rings round it, each wider by a
/// fourteenth than the one within, of 160 corners, out to `reach_m`. Each corner is on the surface
/// of the run's own waves; between two of them, d apart, a wave of length L and amplitude a lies
/// off the triangle by up to a (pi d / L)^2 / 2. Far from the middle short waves are so only
/// sampled: a picture from there would need a middle of its own.
///
/// The topology rests on the reach alone, so that a corner is the same water column at each moment.
/// @param sea       null: calm
/// @param middle_m  NED of the run; z unused
/// @param t_s       since the sea's epoch
[[nodiscard]] TriangleMesh sea_mesh(const SeaRealisation* sea, const Triple<double>& middle_m,
                                    double reach_m, double t_s);

}  // namespace slackwater::twin
