#pragma once
#include <vector>

#include "fields/base/constants.h"
#include "twin/curve/uniform_axis.h"

namespace slackwater::twin {

/// What a propeller does in open water, by its advance ratio J = Va/(n D):
///
///   T = rho D^4 n|n| K_T(J),   Q = rho D^5 n|n| K_Q(J),   n in turns per second,
///
/// with straight lines between the places of the table, one for either way it turns. J counts the
/// flow along the thrust of that way; flow from behind counts as none, and beyond the last place,
/// where it pushes no more, the numbers are those there (a propeller that the flow turns is not
/// known).
/// Source: Carlton, Marine Propellers and Propulsion (4th ed., 2019), ch. 6.
struct OpenWater {
  UniformAxis ahead_ratio;
  UniformAxis astern_ratio;
  /// Of each place four numbers, those ahead first: K_T rho D^4/(4 pi^2) there and at the next
  /// place, K_Q rho D^5/(4 pi^2) likewise. Empty: nobody knows.
  std::vector<double> step;
  bool has_torque = false;  ///< without K_Q the power is that of the actuator disc
  double diameter_m = 0;
  double flow_share = 1;    ///< 1 - w: of the speed through the water, what reaches the propeller
  double thrust_share = 1;  ///< 1 - t: of its thrust, what the hull does not take back
  double torque_share = 1;  ///< of its torque, what turns the hull (a stator takes the rest)

  [[nodiscard]] bool is_known() const noexcept { return !step.empty(); }
  /// J times the speed of the shaft over the speed through the water.
  [[nodiscard]] double ratio_per_turn() const noexcept {
    return 2 * constants::pi * flow_share / diameter_m;
  }
};

/// Thrust of the propeller and torque at its shaft, in its own sense.
template <typename Real>
struct OpenWaterLoad {
  Real thrust_n{};
  Real torque_n_m{};
};

/// @param shaft_rad_s  negative: astern
/// @param advance_m_s  of the hull through the water, along positive thrust
template <typename Real>
[[nodiscard]] OpenWaterLoad<Real> load_of(const OpenWater& water, const Real& shaft_rad_s,
                                          const Real& advance_m_s) {
  const auto turns_astern = shaft_rad_s < 0.0;
  const Real way = select(turns_astern, Real{} - 1.0, Real{} + 1.0);
  const Real turning = larger_of(absolute(shaft_rad_s), Real{} + 1e-9);  // at rest no 0/0
  const Real ratio = water.ratio_per_turn() * (way * advance_m_s) / turning;
  const PlaceOnAxis<Real> ahead = place_on(water.ahead_ratio, ratio);
  const PlaceOnAxis<Real> astern = place_on(water.astern_ratio, ratio);
  const Real share = select(turns_astern, astern.share, ahead.share);
  const Real entry = select(
      turns_astern, Real{static_cast<double>(water.ahead_ratio.count) + astern.below}, ahead.below);
  const std::array<Real, 4> at = four_entries_of(water.step.data(), entry);
  const Real turning2 = shaft_rad_s * absolute(shaft_rad_s);
  return {turning2 * (at[0] + share * (at[1] - at[0])),
          turning2 * (at[2] + share * (at[3] - at[2]))};
}

/// The slowest shaft with that thrust of the propeller at that speed through the water, 0 for none
/// at all; exact. Astern where the thrust is.
/// @throws nothing; without bound for a thrust that no speed gives
[[nodiscard]] double shaft_for(const OpenWater& water, double thrust_n, double advance_m_s);

}  // namespace slackwater::twin
