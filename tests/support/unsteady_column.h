#pragma once
#include <span>
#include <vector>

#include "fields/current/steady_column.h"
#include "fields/current/stress_memory.h"

namespace slackwater {

/// The unsteady column written plainly, in double precision and mode by mode: what the model with
/// its derivatives (calibration/residuals/column_rows.h) is held against.
///
/// What the unsteady column adds to the steady one: the steady answer to the wind of this instant
/// has arrived at once, the sea's has not. Per mode n, with m_n the stress memory of lambda_n:
///
///   W(z, t) = W_interior A(z) + T(t) B(z) + transient,
///   transient(z, t) = - sum_n B_n(z) m_n(t),   sum_n B_n(z) = B(z)
///
/// exact for constant viscosity and linear drag on the base of the layer (column_modes.h), with no
/// new parameter: the water column in finite_depth, the mixed layer in mixed_layer. Under a
/// constant wind the transient dies and the steady form is left. Modes that forget within five
/// minutes answer at once. three_layer stays steady: it does not say how deep the layer is that
/// moves.
///
/// No rotation, no transient: empty in the equatorial band.
class UnsteadyColumn {
 public:
  UnsteadyColumn(SteadyForm form, const SteadyParameters& parameters, Angle latitude,
                 double water_depth_m, std::span<const double> depths_m,
                 const HourlyStress& stress);

  /// The transient at all depths, m/s: at an instant, or the mean over the interval.
  void transient(const TimeCell& cell, std::span<Horizontal> out) const;
  [[nodiscard]] std::size_t levels() const noexcept { return levels_; }

 private:
  std::size_t levels_ = 0;
  std::vector<StressMemory> memory_;  ///< per mode
  std::vector<Horizontal> response_;  ///< modes x levels: B_n, m/s per Pa
};

/// Depth of the layer that the wind moves: the water's, or the mixed layer's.
[[nodiscard]] double moving_layer_m(SteadyForm form, const SteadyParameters& parameters,
                                    double water_depth_m) noexcept;

}  // namespace slackwater
