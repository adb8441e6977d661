#pragma once
#include "fields/base/config.h"
#include "twin/body/body.h"

namespace slackwater::twin {

/// What a vehicle's YAML says of its body: `dimensions_m`, `rigid_body`, `displacement`,
/// `water_density_kg_m3`, `drag_stations`, `hulls`, `trailing_edge`; `added_mass`, `damping` and
/// `lift` (read_derivatives.h); `cross_flow` (read_cross_flow.h).
///
/// Throws Error(invalid_input), with file, line and reason, for what no body can be: a mass matrix
/// that is not positive definite, moments of inertia that break the triangle inequality or want
/// mass beyond the hull, a derivative of the wrong sign, a density that is a slip of units.
[[nodiscard]] Body read_body(const Config& vehicle);

}  // namespace slackwater::twin
