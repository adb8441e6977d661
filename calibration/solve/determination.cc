#include "calibration/solve/determination.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <sstream>

#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

constexpr double determined_share = 0.8;  ///< of the prior's standard deviation

std::string bound_warning(const Parameter& p, bool is_lower) {
  std::ostringstream text;
  text << p.name << " ended on its " << (is_lower ? "lower" : "upper") << " bound of "
       << (is_lower ? p.lower : p.upper) << ' ' << p.unit
       << ": the day asks for what the steady model cannot give";
  return text.str();
}

std::string direction_warning(const Eigen::VectorXd& direction, double share,
                              const std::vector<Parameter>& parameters) {
  std::ostringstream text;
  text.precision(2);
  text << "the day hardly determines";
  bool is_first = true;
  for (Eigen::Index i = 0; i < direction.size(); ++i) {
    if (std::abs(direction(i)) < 0.3) continue;
    const Parameter& p = parameters[static_cast<std::size_t>(i)];
    text << (is_first ? " " : direction(i) < 0 ? " - " : " + ");
    if (is_first && direction(i) < 0) text << '-';
    if (std::abs(direction(i)) < 0.95) text << std::abs(direction(i)) << ' ';
    text << (p.is_logarithmic ? "ln " : "") << p.name;
    is_first = false;
  }
  text << " (in prior standard deviations): its uncertainty is " << std::round(100.0 * share)
       << " % of the prior's";
  return text.str();
}

}  // namespace

std::vector<std::string> judge_determination(const std::vector<double>& estimate,
                                             const Eigen::MatrixXd& covariance,
                                             std::vector<Parameter>& parameters) {
  std::vector<std::string> warnings;
  Eigen::VectorXd prior_sigma(covariance.rows());
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    Parameter& p = parameters[i];
    const auto row = static_cast<Eigen::Index>(i);
    p.value = physical(p, estimate[i]);
    p.sigma = std::sqrt(covariance(row, row));
    p.weakly_determined = p.sigma > determined_share * p.prior_sigma;
    prior_sigma(row) = p.prior_sigma;
    const double low = estimated(p, p.lower);
    const double high = estimated(p, p.upper);
    const double near = 1e-6 * (high - low);
    const bool is_lower = estimate[i] <= low + near;
    p.at_bound = is_lower || estimate[i] >= high - near;
    if (p.at_bound) warnings.push_back(bound_warning(p, is_lower));
  }
  const Eigen::VectorXd inverse = prior_sigma.cwiseInverse();
  const Eigen::MatrixXd whitened = inverse.asDiagonal() * covariance * inverse.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(whitened);
  for (Eigen::Index i = 0; i < whitened.rows(); ++i) {
    const double share = std::sqrt(std::max(eigen.eigenvalues()(i), 0.0));
    if (share > determined_share) {
      warnings.push_back(direction_warning(eigen.eigenvectors().col(i), share, parameters));
    }
  }
  return warnings;
}

}  // namespace slackwater::calibration
