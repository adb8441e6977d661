#pragma once
#include <optional>
#include <string>

#include "fields/base/config.h"
#include "twin/body/body.h"

namespace slackwater::twin {

// Derivatives stand in the file with the names and the signs of SNAME (T&R 1-5, 1950): the letter
// of a force or moment, X Y Z K M N, and those of the motions that it goes with, u v w p q r. What
// resists motion along its own axis is negative there; inside, masses and dampings are positive.

/// `added_mass`: `X_u_dot` to `N_r_dot`, and off the diagonal `Y_r_dot`, `Z_q_dot`, ...; one of a
/// symmetric pair is enough.
///
/// Throws Error(invalid_input) for a diagonal above 0 and a pair that differs by more than 0.1 %.
[[nodiscard]] SpatialMatrix read_added_mass(const Config& vehicle);

/// `damping`: linear, `X_u` to `N_r` and off the diagonal `Y_r`, `M_w`, ...; quadratic, `X_u_abs_u`
/// to `N_r_abs_r` and `Y_r_abs_r`, `N_v_abs_v`, `Z_q_abs_q`, `M_w_abs_w`.
void read_damping(const Config& vehicle, Body& body);

/// `lift`: `Y_uv`, `Y_ur`, `N_uv`, `N_ur`, `Z_uw`, `Z_uq`, `M_uw`, `M_uq`, `K_up`, of a vehicle
/// that goes ahead, and `munk`, how its source counts the moment of the added mass in a flow from
/// aside: `apart` (the derivatives are lift alone), `included` (they hold it, so that it is taken
/// off them), `left_out` (the source has none, and none is to act).
///
/// After `added_mass` and `trailing_edge`.
void read_lift(const Config& vehicle, Body& body);

/// A motion that linear damping drives instead of resisting it, in words; nothing: it resists all.
[[nodiscard]] std::optional<std::string> motion_driven_by_damping(const Body& body);

}  // namespace slackwater::twin
