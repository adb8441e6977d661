#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/stress_memory.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What the unsteady column adds to the steady one: the steady answer to the wind of this instant
/// has arrived at once, the sea's has not. Per mode n, with m_n the stress memory of lambda_n:
///
///   W(z, t) = W_interior A(z) + T(t) B(z) + transient,
///   transient(z, t) = - sum_n B_n(z) m_n(t),   sum_n B_n(z) = B(z)
///
/// finite_depth: the exact modes of the column whose steady form was fitted (constant viscosity,
/// linear drag), no new parameter. With d the depth,
///
///   k_n tan(k_n H) = r/nu,   phi_n = cos(k_n d),   lambda_n = i f + nu k_n^2,
///   B_n = phi_n(d)/(rho N_n lambda_n),   N_n = H/2 (1 + sin(2 k_n H)/(2 k_n H))
///
/// Modes that forget within five minutes answer at once, as in the steady form.
///
/// three_layer: one mode that carries all of B, lambda = `deep_damping_per_h` + i f: the mixed layer
/// of the open sea moves as one, and its inertial motion decays by radiation of waves, which no
/// eddy viscosity describes.
///
/// No rotation, no transient: empty in the equatorial band, and without wind.
class TransientColumn {
 public:
  TransientColumn(const Calibration& calibration, const LevelResponses& responses,
                  const HourlyStress& stress, double deep_damping_per_h);

  /// At depth `k` of the responses, m/s: at an instant, or the mean over the interval.
  [[nodiscard]] Horizontal velocity(std::size_t k, const TimeCell& cell) const;
  /// Of all depths of the responses.
  void velocities(const TimeCell& cell, std::span<Horizontal> out) const;

 private:
  std::size_t levels_ = 0;
  std::vector<StressMemory> memory_;  ///< per mode
  std::vector<Horizontal> response_;  ///< modes x levels: B_n, m/s per Pa
};

/// Wavenumber k_n, 1/m: the root of k tan(kH) = r/nu in [n pi/H, (n + 1/2) pi/H), n = 0 the gravest.
[[nodiscard]] double column_mode_wavenumber_1_m(int n, double eddy_viscosity_m2_s,
                                                double bottom_friction_m_s, double water_depth_m);

}  // namespace slackwater::calibration
