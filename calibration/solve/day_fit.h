#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/calibration.h"
#include "calibration/solve/observations.h"

namespace slackwater::calibration {

/// Everything the minimiser needs of a day.
struct DayProblem {
  ColumnDay day;
  std::vector<Pair> pairs;
  std::vector<Parameter> parameters;  ///< priors and bounds, in the order of the layout
  double sigma_m_s = 0.02;            ///< whitening of the pairs, at best
};

/// A minimum.
struct DayMinimum {
  std::vector<double> estimate;  ///< in the order of the parameters, logarithms where so
  double cost = 0;               ///< half the sum of robust squares and of the priors'
  int iterations = 0;
  std::string termination;  ///< one sentence
};

/// The least-squares problem of one day, handed to Ceres: a block of two residuals per pair under a
/// Huber loss, and one residual per prior. The model is evaluated once per point for all pairs and
/// shared by the blocks, so that a block costs nanoseconds.
///
/// The Huber threshold is 2 whitened units of the two-component residual: a pair beyond it counts
/// linearly.
class DayFit {
 public:
  explicit DayFit(const DayProblem& problem);
  ~DayFit();
  DayFit(const DayFit&) = delete;
  DayFit& operator=(const DayFit&) = delete;

  /// How far the minimum is followed: until a step lowers the cost by less than 1e-4, or 1e-9, of
  /// it.
  enum class Precision { rough, full };

  /// Minimises from a start within the bounds. `weight` multiplies the robust cost of every pair:
  /// the share of the pairs that is independent. May be called again with another whitening. Throws
  /// Error(not_converged).
  [[nodiscard]] DayMinimum minimise(const std::vector<double>& start, double sigma_m_s,
                                    double weight, Precision precision);

  /// Information (inverse covariance) of the pairs at a point: weight * sum of rho' J^T J; n x n.
  [[nodiscard]] Eigen::MatrixXd information(const std::vector<double>& estimate, double sigma_m_s,
                                            double weight);

  /// The model at a point.
  [[nodiscard]] const ColumnRows::Matrix& model(const std::vector<double>& estimate);
  /// Its wind-driven part at the point last asked for.
  [[nodiscard]] const ColumnRows::Matrix& wind_driven() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Huber's weight rho'(s) for a squared, whitened residual s: 1 below the threshold of `DayFit`.
[[nodiscard]] double robust_weight(double squared_residual) noexcept;

}  // namespace slackwater::calibration
