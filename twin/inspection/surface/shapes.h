#pragma once
#include "fields/base/config.h"
#include "twin/inspection/surface/surface.h"

// Only sources of this folder include this.

namespace slackwater::twin {

// Each kind by its own file; the keys are those of make_surface.h.
// @throws Error(invalid_input), TooManyPatches

[[nodiscard]] Surface make_monopile(const Config& config, double patch_m);
[[nodiscard]] Surface make_transition_piece(const Config& config, double patch_m);
[[nodiscard]] Surface make_tower(const Config& config, double patch_m);
[[nodiscard]] Surface make_nacelle(const Config& config, double patch_m);
[[nodiscard]] Surface make_blade(const Config& config, double patch_m);
[[nodiscard]] Surface make_anodes(const Config& config, double patch_m);
[[nodiscard]] Surface make_mooring_line(const Config& config, double patch_m);
[[nodiscard]] Surface make_cable(const Config& config, double patch_m);
[[nodiscard]] Surface make_bed(const Config& config, double patch_m);
[[nodiscard]] Surface make_water(const Config& config, double patch_m);

}  // namespace slackwater::twin
