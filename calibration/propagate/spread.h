#pragma once
#include "calibration/propagate/memory_kernel.h"

namespace slackwater::calibration {

/// How the wind of the horizon is wrong: a Gauss-Markov departure per component.
///
///   sigma^2(lead) = at_once^2 + limit^2 (1 - e^{-2 lead/growth_h}),   correlation e^{-|d|/memory_h}
struct WindError {
  double at_once_m_s = 0.0;  ///< at the end of D
  double limit_m_s = 0.0;    ///< grown to after some growth times
  double growth_h = 48.0;
  double memory_h = 12.0;
};

/// Every figure that the spread of a forecast rests on, beside the covariance that the data give
/// themselves. One set for all sites and seasons.
struct Spread {
  MemoryKernel memory;  ///< what a level remembers of D, and how it departs from it
  /// E-folding time of free inertial motion where no bed is felt, h: 1 to 4 days (D'Asaro 1985, J.
  /// Phys. Oceanogr. 15, 1043).
  double inertial_decay_h = 96.0;
  /// Stress that may be blowing where the wind is missing, Pa, per component: that of 7.5 m/s.
  double unknown_stress_pa = 0.1;
  WindError wind;
  int members = 24;  ///< beside member 0; even
};

}  // namespace slackwater::calibration
