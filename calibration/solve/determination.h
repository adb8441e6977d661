#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// Fills value, sigma, at_bound and weakly_determined of each parameter from the optimum and its
/// posterior covariance, and returns a warning for each bound that is reached and each direction
/// that the day leaves where the prior put it.
///
/// A direction is an eigenvector of the covariance measured in prior standard deviations; the day
/// counts as having determined it when its standard deviation fell below 0.8 of the prior's.
[[nodiscard]] std::vector<std::string> judge_determination(const std::vector<double>& estimate,
                                                           const Eigen::MatrixXd& covariance,
                                                           std::vector<Parameter>& parameters);

}  // namespace slackwater::calibration
