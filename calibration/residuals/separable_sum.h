#pragma once
#include <Eigen/Core>

#include "fields/base/frame.h"

namespace slackwater::calibration {

/// Complex numbers over times and levels as real ones: all east parts, then all north parts, each
/// times x levels.
using Planes = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using OverTime = Eigen::VectorXcd;
using OverLevels = Eigen::RowVectorXcd;

/// A sum of products p(t) s(z), written out at once as one real matrix product: most functions of
/// depth in a column are real (the cosines of its modes), and complex arithmetic would cost double.
class SeparableSum {
 public:
  SeparableSum(Eigen::Index times, Eigen::Index levels) : times_(times), levels_(levels) {}

  void clear() noexcept { terms_ = 0; }
  void add(const OverTime& p, const Eigen::RowVectorXd& s);
  void add(const OverTime& p, const OverLevels& s);
  /// The sum; 2 times x levels.
  void write(Eigen::Ref<Planes> out) const;

 private:
  void reserve(Eigen::Index terms);

  Eigen::Index times_;
  Eigen::Index levels_;
  Eigen::Index terms_ = 0;
  Eigen::MatrixXd over_time_;  ///< 2 times x terms
  Planes over_levels_;         ///< terms x levels
};

}  // namespace slackwater::calibration
