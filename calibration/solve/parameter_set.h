#pragma once
#include <vector>

#include "calibration/residuals/prior.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// The parameters that a day estimates, in the order of `ParameterIndex`, with priors, bounds and
/// sources.
[[nodiscard]] std::vector<Parameter> prior_parameters(SteadyForm form, bool is_equatorial,
                                                      bool wind_used);

/// The value in the terms of the estimate: itself, or its logarithm.
[[nodiscard]] double estimated(const Parameter& parameter, double value);
/// The inverse of `estimated`.
[[nodiscard]] double physical(const Parameter& parameter, double estimate);
/// The prior in the terms of the estimate.
[[nodiscard]] Prior prior_of(const Parameter& parameter);

}  // namespace slackwater::calibration
