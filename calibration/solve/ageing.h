#pragma once
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// How quickly what a day has taught of the water's turbulence grows stale. Each is a standard
/// deviation of the logarithm that a day adds (random walk), up to that of the general prior: eddy
/// viscosity and mixed-layer depth follow the weather of a day or two (a factor 1.6 and 1.3),
/// friction the bed and the tide, the stress factor the wind product.
struct Ageing {
  double eddy_viscosity = 0.5;
  double mixed_layer_depth = 0.3;
  double friction = 0.3;
  double stress_factor = 0.1;
};

/// Yesterday's posterior as today's prior: the parameters that shape the column and the stress
/// factor, each with the variance of its posterior and of the days between. The means fall back
/// toward the general prior in the measure in which its variance is reached. Interior, trend
/// and inertial motion are the day's own.
///
/// @param days_between  1 for the day after
[[nodiscard]] std::vector<KnownParameter> aged(const Calibration& earlier, double days_between,
                                               const Ageing& ageing = {});

}  // namespace slackwater::calibration
