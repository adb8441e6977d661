#pragma once
#include "twin/search/leeway.h"

namespace slackwater::twin {

/// Something adrift: what it is changes no more, where it is does.
struct Drifter {
  LeewayDraw leeway;
  double jibe_rate_per_s = 0;
  /// K of the walk that stands for eddies which the forecast does not resolve.
  double diffusivity_m2_s = 0;
};
struct DrifterState {
  Triple<double> position_m;  ///< NED, at the surface
  bool is_left = false;       ///< of downwind
  Rng rng{0, ""};
};

/// Where it starts: normal about the last known position, sides drawn evenly.
/// @param radius_m  within which it was with probability 1/2 (probable error, IAMSAR)
[[nodiscard]] DrifterState begin_drift(const Triple<double>& last_known_m, double radius_m,
                                       Rng rng) noexcept;

/// Carries it along for a step: dx = (current + leeway) dt + sqrt(2 K dt) n on each axis, then it
/// jibes with probability 1 - exp(-rate dt). Draws as many numbers whatever the settings.
///
/// @param current_m_s   of the water, over ground, NED
/// @param wind_10m_m_s  NED
void drift(const Drifter& drifter, const Triple<double>& current_m_s,
           const Triple<double>& wind_10m_m_s, double dt_s, DrifterState& state) noexcept;

}  // namespace slackwater::twin
