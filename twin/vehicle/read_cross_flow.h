#pragma once
#include "fields/base/config.h"
#include "twin/body/body.h"

namespace slackwater::twin {

/// `cross_flow`: drag across the hull in strips between `from_x_m` and `to_x_m`, `strips` of them;
/// `sway: {drag_coefficient, depth_m}` and `heave: {drag_coefficient, breadth_m}`, each a number or
/// one for each strip from the stern on. Instead of its two a floating hull's sway may have
/// `section: {breadth_m, draught_m}`, whose coefficient is Hoerner's.
///
/// Throws Error(invalid_input) for strips beyond the hull, and beside `Y_v_abs_v` or `Z_w_abs_w`,
/// which say the same. After `damping`.
void read_cross_flow(const Config& vehicle, double length_m, Body& body);

/// Drag coefficient of a section of the breadth B afloat on the draught T in a flow from aside, by
/// B/2T from 0.0109 to 4. Source: Hoerner, Fluid-Dynamic Drag (1965); the points are those that
/// Fossen's MSS toolbox has of his figure, after Leite and others (Applied Ocean Research 20,
/// 1998).
[[nodiscard]] double hoerner_drag_coefficient(double half_breadth_per_draught);

}  // namespace slackwater::twin
