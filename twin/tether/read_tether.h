#pragma once
#include <optional>

#include "fields/base/config.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// `tether` of a vehicle's YAML: `longest_m`, `diameter_m`, `mass_per_m_kg`, `breaking_load_n`, and
/// optionally `elongation_at_break` (a strain), `normal_drag_coefficient`,
/// `tangential_drag_coefficient`, `attachment_m`. Nothing for a vehicle without one.
/// `vehicle_mobility_per_kg` is left to whoever knows the vehicle's mass.
/// @throws Error(invalid_input) for what no line can be
[[nodiscard]] std::optional<Tether> read_tether(const Config& vehicle);

}  // namespace slackwater::twin
