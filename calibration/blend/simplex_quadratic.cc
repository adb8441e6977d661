#include "calibration/blend/simplex_quadratic.h"

#include <Eigen/Cholesky>
#include <vector>

#include "fields/base/check.h"

namespace slackwater::calibration {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A multiplier below this share of the largest entry of A is rounding.
constexpr double rounding = 1e-12;

/// The minimum over the free shares with sum 1, their signs free: A x = b + mu 1.
VectorXd minimum_of_free(const MatrixXd& a, const VectorXd& b, const std::vector<Index>& free) {
  const MatrixXd block = a(free, free);
  const Eigen::LLT<MatrixXd> factor(block);
  expects(factor.info() == Eigen::Success, "the quadratic form of a blend is positive definite");
  const VectorXd ones = VectorXd::Ones(block.rows());
  const VectorXd without = factor.solve(VectorXd(b(free)));
  const VectorXd per_unit = factor.solve(ones);
  return without + (1.0 - without.sum()) / per_unit.sum() * per_unit;
}

/// The bound that is met first on the way from `from` to `to`: its place among the free, and how
/// far.
struct Bound {
  std::size_t place = 0;
  double step = 1.0;
};

Bound first_bound(const VectorXd& from, const VectorXd& to) {
  Bound bound;
  for (Index j = 0; j < to.size(); ++j) {
    if (to[j] >= 0) continue;
    const double step = from[j] / (from[j] - to[j]);
    if (step < bound.step) bound = {static_cast<std::size_t>(j), step};
  }
  return bound;
}

/// The share at its bound whose release lowers the cost most; -1: none, `w` is the minimum.
Index share_to_free(const MatrixXd& a, const VectorXd& b, const VectorXd& w,
                    const std::vector<Index>& free) {
  const VectorXd slope = a * w - b;
  double level = 0;
  for (const Index i : free) level += slope[i] / static_cast<double>(free.size());
  Index best = -1;
  double lowest = level - rounding * a.cwiseAbs().maxCoeff();
  for (Index i = 0; i < w.size(); ++i) {
    if (w[i] == 0.0 && slope[i] < lowest) {
      lowest = slope[i];
      best = i;
    }
  }
  return best;
}

}  // namespace

VectorXd minimise_on_simplex(const MatrixXd& a, const VectorXd& b) {
  expects(b.size() > 0 && a.rows() == b.size() && a.cols() == b.size(),
          "a blend needs a square form as large as its shares");
  expects(a.allFinite() && b.allFinite(), "the quadratic form of a blend is finite");
  Index start = 0;
  (0.5 * a.diagonal() - b).minCoeff(&start);
  VectorXd w = VectorXd::Unit(b.size(), start);
  std::vector<Index> free{start};
  // Far above the number of sets that are ever visited; a cap so that rounding cannot keep us here.
  // What stands then is feasible and as good as rounding allows.
  for (Index round = 0; round < 100 * b.size(); ++round) {
    const VectorXd now = w(free);
    const VectorXd wanted = minimum_of_free(a, b, free);
    const Bound bound = first_bound(now, wanted);
    w(free) = (now + bound.step * (wanted - now)).cwiseMax(0.0);
    if (bound.step < 1.0) {
      w[free[bound.place]] = 0.0;
      free.erase(free.begin() + static_cast<std::ptrdiff_t>(bound.place));
      continue;
    }
    const Index released = share_to_free(a, b, w, free);
    if (released < 0) break;
    free.push_back(released);
  }
  return w / w.sum();
}

}  // namespace slackwater::calibration
