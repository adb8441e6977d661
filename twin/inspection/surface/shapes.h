#pragma once
#include "twin/inspection/surface/planned_surface.h"

// Only sources of this folder include this.

namespace slackwater::twin {

/// As `make_surface`. @throws Unmakeable, Error(invalid_input)
[[nodiscard]] Surface made(const PlannedSurface& planned, double patch_m);

// Each kind by its own file. @throws Unmakeable, TooManyPatches

[[nodiscard]] Surface make(const MonopileSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const TransitionPieceSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const TowerSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const NacelleSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const BladeSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const AnodesSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const MooringLineSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const CableSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const BedSizes& sizes, double patch_m);
[[nodiscard]] Surface make(const WaterSizes& sizes, double patch_m);

/// @throws Unmakeable where its end is not below its begin
void expect_goes_down(const Upright& upright);

}  // namespace slackwater::twin
