#include "calibration/solve/determination.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "calibration/solve/parameter_set.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

constexpr double determined_share = 0.8;  ///< of the prior's standard deviation
constexpr double member_share = 0.3;      ///< of a direction of length one

std::string bound_warning(const Parameter& p, bool is_lower) {
  return formatted(
      "{} ended at its {} bound of {:g} {}: the steady model does not fit this day well", p.name,
      is_lower ? "lower" : "upper", is_lower ? p.lower : p.upper, p.unit);
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) text += i + 1 == names.size() ? " and " : ", ";
    text += names[i];
  }
  return text;
}

std::string little_said_of(const std::vector<std::string>& names) {
  return "the data of the day tell little about " + listed(names) +
         (names.size() == 1 ? ": its value is mostly the one assumed beforehand"
                            : ": their values are mostly those assumed beforehand");
}

/// The parameters that share a direction.
std::vector<const Parameter*> members_of(const Eigen::VectorXd& direction,
                                         const std::vector<Parameter>& parameters) {
  std::vector<const Parameter*> members;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    if (std::abs(direction(static_cast<Eigen::Index>(i))) >= member_share)
      members.push_back(&parameters[i]);
  }
  return members;
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
  std::vector<std::string> unsaid;
  for (const Parameter& p : parameters) {
    if (p.weakly_determined) unsaid.push_back(p.name);
  }
  std::vector<std::string> together;
  for (Eigen::Index i = 0; i < whitened.rows(); ++i) {
    const double share = std::sqrt(std::max(eigen.eigenvalues()(i), 0.0));
    if (share <= determined_share) continue;
    const auto members = members_of(eigen.eigenvectors().col(i), parameters);
    // A parameter that is weak by itself has its sentence already.
    if (std::any_of(members.begin(), members.end(),
                    [](const Parameter* p) { return p->weakly_determined; })) {
      continue;
    }
    std::vector<std::string> names;
    names.reserve(members.size());
    for (const Parameter* p : members) names.push_back(p->name);
    if (names.size() == 1) {
      unsaid.push_back(names.front());
    } else {
      together.push_back(listed(names) + " cannot be told apart: the day fits as well with " +
                         "one a little off when the " +
                         (names.size() == 2 ? "other makes" : "others make") + " up for it");
    }
  }
  if (!unsaid.empty()) warnings.push_back(little_said_of(unsaid));
  warnings.insert(warnings.end(), together.begin(), together.end());
  return warnings;
}

}  // namespace slackwater::calibration
