#pragma once
#include <vector>

#include "calibration/solve/day_fit.h"

namespace slackwater::calibration {

/// A point to start from, in the valley of the best minimum.
///
/// The shape parameters (eddy viscosity, bed) enter non-linearly and can have several minima;
/// everything else is linear once they are fixed. So the shapes are scanned over a coarse grid
/// within their bounds and the linear rest is solved exactly, with priors, at each point, from sums
/// over the day that are made once. Deterministic. Cost: one pass over the pairs and about a
/// hundred evaluations of the levels' responses.
[[nodiscard]] std::vector<double> first_guess(const DayProblem& problem);

}  // namespace slackwater::calibration
