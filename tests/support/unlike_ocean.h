#pragma once
#include <cstdint>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::tests {

/// A shelf sea at one place whose physics the calibration does not have: viscosity that grows from
/// both boundaries and breathes with wind and tide, a mixed-layer base that moves, quadratic drag
/// on the bed, a tide that is forced by its slope and bent by that drag, an eddying interior, and
/// fronts that pass every few days with a jet in the upper layer.
///
///   W_t + i f W = P(t) + B(z, t) + (K(z, t) W_z)_z
///   K W_z = tau/rho at the surface,   K W_z = C_d |W| W at the bed
///
/// Implicit in depth, Coriolis turned exactly, 2 min steps on 1 m cells. The truth is a function of
/// (seed, length) alone.
class UnlikeOcean {
 public:
  UnlikeOcean(std::uint64_t seed, UtcDay first_day, int days);

  static constexpr double water_depth_m = 34.0;
  static constexpr double latitude_deg = 54.0;

  /// Hourly, linear in between and in depth; Eulerian, towards.
  [[nodiscard]] Horizontal current(UtcTime time, double depth_m) const;
  [[nodiscard]] Horizontal wind(UtcTime time) const;  ///< 10 m, towards
  /// As a weather analysis has it: off by 1 m/s a component, for six hours.
  [[nodiscard]] Horizontal analysed_wind(UtcTime time) const;

 private:
  [[nodiscard]] Horizontal hourly(const std::vector<Horizontal>& series, UtcTime time) const;

  UtcTime start_;
  std::vector<Horizontal> wind_;           ///< per hour
  std::vector<Horizontal> analysed_wind_;  ///< per hour
  std::vector<Horizontal> current_;        ///< hours x cells
};

}  // namespace slackwater::tests
