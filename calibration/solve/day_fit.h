#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/calibration.h"
#include "calibration/solve/normal_equations.h"
#include "calibration/solve/observations.h"

namespace slackwater::calibration {

/// Everything the minimiser needs of a day.
struct DayProblem {
  ColumnDay day;
  std::vector<Pair> pairs;
  std::vector<Parameter> parameters;  ///< priors and bounds, in the order of the layout
  double sigma_m_s = 0.02;            ///< whitening of the pairs, at best
  Loss loss = Loss::huber;
};

/// A minimum.
struct DayMinimum {
  std::vector<double> estimate;  ///< in the order of the parameters, logarithms where so
  double cost = 0;               ///< half the sum of robust squares and of the priors'
  int iterations = 0;
  std::string termination;  ///< one sentence
};

/// The least-squares problem of one day, handed to Ceres: the robust squares of all pairs and one
/// square per prior. Least squares does not see a rotation of its residuals, so the thousands of a
/// day are handed over rotated onto the directions of their n parameters:
///
///   r = [L^{-1} g, sqrt(2 cost - |L^{-1} g|^2)],   J = [L^T, 0],
///   L L^T = information,   g = gradient
///
/// the same cost, gradient and Gauss-Newton step from n + 1 numbers.
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

  /// The model at a point. With derivatives where a minimisation or the information comes next:
  /// they are not made again.
  [[nodiscard]] const ColumnRows& at(const std::vector<double>& estimate, bool with_derivatives);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slackwater::calibration
