#pragma once
#include <vector>

#include "twin/body/vehicle_kind.h"
#include "twin/inspection/surface/triangle_mesh.h"
#include "twin/scene/structure.h"

namespace slackwater::twin {

/// What a structure of a scenario looks like: an upright prism of 96 faces within the cylinder, or
/// the box. Closed, outward.
[[nodiscard]] TriangleMesh mesh_of(const Structure& structure);

/// A stand-in for a vehicle's hull, as long, wide and high as its sheet says, closed and outward:
/// an AUV is a spindle of 24 faces with rounded ends, boats have a raked bow, all else is a box
/// with its edges cut by a fifth.
/// @param size_m  length, width, height
/// @param body    axes to NED
[[nodiscard]] TriangleMesh hull_mesh(VehicleKind kind, const Triple<double>& size_m,
                                     const Triple<double>& position_m,
                                     const Rotation<double>& body);

/// A line through places, of which no two neighbours are one: six faces, closed, outward.
/// @param at_m  two or more
[[nodiscard]] TriangleMesh line_mesh(const std::vector<Triple<double>>& at_m, double diameter_m);

/// A level bed: squares of `square_m` up to `reach_m` north and east of a place, but for those
/// whose corner is within one of the discs, where something else shows the bed.
struct LevelDisc {
  double north_m = 0;
  double east_m = 0;
  double radius_m = 0;
};
[[nodiscard]] TriangleMesh bed_mesh(const Triple<double>& middle_m, double reach_m, double square_m,
                                    const std::vector<LevelDisc>& left_out);

}  // namespace slackwater::twin
