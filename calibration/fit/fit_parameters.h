#pragma once
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "calibration/fit/residual_series.h"

namespace slackwater::calibration {

/// A number that a fit may change, between two bounds.
struct FreeParameter {
  std::string name;
  double start = 0;
  double low = 0;
  double high = 0;
};

/// Parameters -> residuals, of a fixed number; false: they cannot be computed there. Never throws,
/// never gives a NaN with true; smooth, for slopes are taken by differences of 1e-5.
using ResidualsOf = std::function<bool(std::span<const double> parameters, std::span<double> out)>;

enum class EndedOn { neither, low, high };

struct FittedParameter {
  std::string name;
  double start = 0;
  double low = 0;
  double high = 0;
  double value = 0;
  /// Nothing: the residuals do not change with it, or it cannot be told apart from another one.
  std::optional<double> standard_deviation;
  /// Whether the residuals say more of it than its bounds do: a standard deviation below that of a
  /// value that is anywhere between them, (high - low)/sqrt(12).
  bool is_determined = false;
  EndedOn ended_on = EndedOn::neither;  ///< its deviation then holds for the slope there alone
};

struct ParameterFit {
  std::vector<FittedParameter> parameters;
  Eigen::MatrixXd correlation;  ///< between their errors; 0 where one has no standard deviation
  double rms_before = 0;        ///< root mean square of all residuals
  double rms_after = 0;
  std::size_t residuals = 0;
  double effective_residuals = 0;  ///< independent ones that they are worth
  bool has_converged = false;
  std::string ended;  ///< "converged after 7 steps: ..."
};

struct FitOptions {
  int most_steps = 50;
  int threads = 1;  ///< for slopes; with more the function is called by several at a time
};

/// Least squares of a black box by Levenberg-Marquardt within bounds, slopes by central
/// differences.
///
/// A misfit of ways and turns has more than one valley: besides from the start it is searched from
/// the best of seven values of each parameter, one after the other, where one is clearly better,
/// and the lower of the two ends counts. It need not be the lowest of all.
///
/// Plain squares, not robust: a model that is wrong in a part of the rows, a turn, is wrong there
/// throughout, and a robust loss would leave that part out as if it were noise. Who has outliers
/// takes them out of the data.
///
/// The covariance of the parameters is that of a weighted sum of residuals whose errors have
/// memory, unlike sizes and something in common,
///
///   (J^T J)^-1 [J^T V J] (J^T J)^-1,
///
/// with V of the residuals that are left (residual_series.h), times n_eff / (n_eff - parameters).
/// For one series of white residuals that is the textbook's s^2 (J^T J)^-1. What the model itself
/// has wrong moves parameters by more.
/// Source: White, Econometrica 48 (1980), for unlike sizes; Bayley and Hammersley (1946), memory.
///
/// @param place  of each residual
/// @throws Error(not_converged) where the residuals cannot be computed at the start, or where the
/// search ends
[[nodiscard]] ParameterFit fit_parameters(const std::vector<FreeParameter>& parameters,
                                          const std::vector<ResidualPlace>& place,
                                          const ResidualsOf& residuals_of,
                                          const FitOptions& options = {});

}  // namespace slackwater::calibration
