#pragma once
#include <vector>

#include "calibration/solve/day_fit.h"

namespace slackwater::calibration {

/// A start for the minimiser in the right valley: over a coarse grid of the parameters that shape
/// the column (viscosity, bottom, mixed-layer depth; two standard deviations of their priors either
/// way) all others, in which the model is linear, are solved for, and the best is taken. The stress
/// factor is linear about 1. One grid point costs one evaluation of the model with its derivatives.
[[nodiscard]] std::vector<double> first_guess(const DayProblem& problem);

}  // namespace slackwater::calibration
