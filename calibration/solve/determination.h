#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// Fills value, sigma, at_bound and weakly_determined of each parameter from the optimum and its
/// posterior covariance, and returns a warning for each bound that is reached, one that names all
/// parameters the day says little about, and one for each combination that is weak though none of
/// its parameters is weak by itself.
///
/// A combination is an eigenvector of the covariance measured in prior standard deviations; the day
/// counts as having determined it when its standard deviation fell below 0.8 of the prior's.
[[nodiscard]] std::vector<std::string> judge_determination(const std::vector<double>& estimate,
                                                           const Eigen::MatrixXd& covariance,
                                                           std::vector<Parameter>& parameters);

}  // namespace slackwater::calibration
