#pragma once
#include <vector>

#include "calibration/residuals/parameter_layout.h"
#include "calibration/residuals/prior.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// The parameters that a day estimates, in the order of the layout, with priors, bounds and
/// sources. `known` (yesterday's posterior, aged) replaces the prior of the parameters it names.
[[nodiscard]] std::vector<Parameter> prior_parameters(const ParameterLayout& layout,
                                                      double water_depth_m,
                                                      const std::vector<KnownParameter>& known);

/// The value in the terms of the estimate: itself, or its logarithm.
[[nodiscard]] double estimated(const Parameter& parameter, double value);
/// All of them.
[[nodiscard]] std::vector<double> estimates_of(const std::vector<Parameter>& parameters);
/// The estimate with interior, trend and free inertial motion set to zero: what the wind makes
/// is left.
[[nodiscard]] std::vector<double> without_flow(std::vector<double> estimate,
                                               const ParameterLayout& layout);
/// The inverse of `estimated`.
[[nodiscard]] double physical(const Parameter& parameter, double estimate);
/// The prior in the terms of the estimate.
[[nodiscard]] Prior prior_of(const Parameter& parameter);

}  // namespace slackwater::calibration
