#pragma once
#include <optional>

#include "twin/sensor/noise.h"

namespace slackwater::twin {

/// A satellite receiver: position with white noise (receiver, multipath) and a slow error
/// (ionosphere, orbits, clocks) that a first-order Gauss-Markov process stands for; velocity with
/// white noise. No fix while the antenna is under water nor for `reacquisition_s` after it.
///
/// Source of the model: Rankin, GPS and Differential GPS: an error model for sensor simulation
/// (IEEE PLANS 1994), who fits minutes to an hour. The numbers are estimates for a single-frequency
/// receiver with SBAS: 95 % of its fixes within 2.4 m.
struct Gnss {
  double white_horizontal_sd_m = 0.3;
  double white_vertical_sd_m = 0.6;
  GaussMarkov slow_horizontal_m{0.93, 600};
  GaussMarkov slow_vertical_m{1.5, 600};
  double velocity_sd_m_s = 0.05;
  double reacquisition_s = 5;
  double rate_hz = 5;         ///< of fixes
  double antenna_up_m = 0.3;  ///< above the vehicle's origin; an estimate: on a short mast
};

struct GnssState {
  NoiseStream noise;
  Triple<double> slow_m;
  double seen_s = 0;  ///< since the antenna came up
};
[[nodiscard]] GnssState started(const Gnss& gnss, const NoiseStream& noise) noexcept;

struct GnssFix {
  Triple<double> position_m;  ///< NED
  Triple<double> velocity_m_s;
};

/// @param antenna_m  NED; @param surface_m z of the sea's surface there
/// @param dt_s       since the last call
[[nodiscard]] std::optional<GnssFix> measured(const Gnss& gnss, GnssState& state,
                                              const Triple<double>& antenna_m,
                                              const Triple<double>& velocity_m_s, double surface_m,
                                              double dt_s) noexcept;

}  // namespace slackwater::twin
