#pragma once
#include <vector>

#include "calibration/propagate/memory_kernel.h"

namespace slackwater::calibration {

/// Every figure that the spread of a forecast rests on, beside the covariance that the data give
/// themselves, the error of the wind (wind_error.h) and what past bands have earned
/// (calibration/blend/earned_spread.h). One set for all sites and seasons.
struct Spread {
  MemoryKernel memory;  ///< what a level remembers of D, and how it departs from it
  /// E-folding time of free inertial motion where no bed is felt, h: 1 to 4 days (D'Asaro 1985, J.
  /// Phys. Oceanogr. 15, 1043).
  double inertial_decay_h = 96.0;
  /// Stress that may be blowing where the wind is missing, Pa, per component: that of 7.5 m/s.
  double unknown_stress_pa = 0.1;
  /// How lively the water may be: the memory's slow, recent and inertial terms times these, each
  /// combination a kernel of its own, believed as its evidence on D says. A regional analysis of
  /// deep water moves by the figures of the kernel, a current meter on a shelf by several times as
  /// much.
  std::vector<double> slow_scales{1.0, 2.0, 4.0, 8.0};
  std::vector<double> recent_scales{1.0, 2.5, 5.0};
  std::vector<double> inertial_scales{1.0, 3.0};
  /// Levels of a column that are independent witnesses of that: neighbours err together.
  double independent_levels = 2.0;
  int members = 24;  ///< beside member 0
  /// Members are drawn in sets of so many, even: the first set says how far an uncertain wind
  /// spreads the current, drawn for this alone where no members are asked for. So sigma is the same
  /// beside 0 members, 24 or 50, a rehearsed band that of the issued forecast, and a member the
  /// same whatever their number (members.h). By the seed the wind's part varies by 13 %
  /// (tests/calibration/propagate/members_test.cc).
  int set_of_members = 24;
};

}  // namespace slackwater::calibration
