#pragma once
#include <Eigen/Core>
#include <array>
#include <vector>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/observations.h"

namespace slackwater::calibration {

/// How a pair far from the model counts: linearly beyond Huber's threshold of 2 whitened units of
/// its two-component residual, or as its square.
enum class Loss { huber, plain };

/// How the pairs of a day count.
struct PairWeighing {
  double sigma_m_s = 0.02;  ///< whitening of each component
  double weight = 1;        ///< multiplies every robust square
  Loss loss = Loss::huber;
};

/// A sum of robust squares at a point, as a Gauss-Newton step sees it. With whitened residuals r of
/// the pairs, J their derivatives and rho the loss:
///
///   cost = weight/2 sum rho(|r|^2),   gradient = weight sum rho' J^T r,
///   information = weight sum rho' J^T J
struct NormalEquations {
  double cost = 0;
  Eigen::VectorXd gradient;
  Eigen::MatrixXd information;
};

/// The misfit of a day's model to its pairs, evaluated once per point and for all pairs at once.
/// The last two points stand: a minimiser tries one, and may go back to where it was.
class DayMisfit {
 public:
  DayMisfit(const ColumnDay& day, const std::vector<Pair>& pairs);

  /// The model there; not evaluated again where it already stands. Good until the next but one
  /// call.
  const ColumnRows& at(const std::vector<double>& estimate, bool with_derivatives);
  [[nodiscard]] const NormalEquations& normal_equations(const std::vector<double>& estimate,
                                                        const PairWeighing& weighing);

 private:
  [[nodiscard]] double weigh(const PairWeighing& weighing);

  struct Point {
    ColumnRows rows;
    std::vector<double> estimate;
    bool has_derivatives = false;
  };

  std::array<Point, 2> points_;  ///< the newest first
  Eigen::ArrayXd observed_;      ///< stacked as ColumnRows stacks them; 0 without a pair
  Eigen::ArrayXd has_pair_;      ///< 1 or 0 for each time and level
  Eigen::ArrayXd sharpness_;     ///< 1 / Pair::relative_sigma
  Eigen::ArrayXd miss_;          ///< model minus observed
  Eigen::ArrayXd root_;          ///< square roots of the weights, the whitening among them
  Eigen::MatrixXd weighted_;
  NormalEquations equations_;
};

}  // namespace slackwater::calibration
