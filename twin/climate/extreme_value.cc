#include "twin/climate/extreme_value.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

constexpr double euler_gamma = 0.57721566490153286;
/// Nearer to 0 a shape is 0: the powers would lose all their digits.
constexpr double no_shape = 1e-9;

/// ((1/t)^shape - 1) / shape, and -ln t for shape 0.
double box_cox_of(double t, double shape) noexcept {
  const double log_t = std::log(t);
  return std::abs(shape) < no_shape ? -log_t : std::expm1(-shape * log_t) / shape;
}

/// Whether some values differ by more than rounding.
bool differ(const LinearMoments& moments) noexcept {
  return moments.l2 > 1e-12 * std::abs(moments.l1);
}

}  // namespace

double Pareto::exceeded_with(double survival) const noexcept {
  return scale * box_cox_of(survival, shape);
}

double Pareto::greatest() const noexcept {
  return shape < 0 ? -scale / shape : std::numeric_limits<double>::infinity();
}

double ExtremeValue::not_exceeded_with(double probability) const noexcept {
  return location + scale * box_cox_of(-std::log(probability), shape);
}

double ExtremeValue::greatest() const noexcept {
  return shape < 0 ? location - scale / shape : std::numeric_limits<double>::infinity();
}

LinearMoments linear_moments(std::vector<double> values) {
  expects(values.size() >= 3, "three moments are those of three values at least");
  std::sort(values.begin(), values.end());
  const auto n = static_cast<double>(values.size());
  double b0 = 0;
  double b1 = 0;
  double b2 = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const auto below = static_cast<double>(i);
    b0 += values[i];
    b1 += below / (n - 1) * values[i];
    b2 += below * (below - 1) / ((n - 1) * (n - 2)) * values[i];
  }
  b0 /= n;
  b1 /= n;
  b2 /= n;
  return {b0, 2 * b1 - b0, 6 * b2 - 6 * b1 + b0};
}

std::optional<Pareto> fitted_pareto(std::vector<double> excesses) {
  const LinearMoments moments = linear_moments(std::move(excesses));
  if (!differ(moments)) return std::nullopt;
  const double ratio = moments.l1 / moments.l2;
  const Pareto fit{moments.l1 * (ratio - 1), 2 - ratio};
  if (!(fit.scale > 0)) return std::nullopt;
  return fit;
}

std::optional<ExtremeValue> fitted_gumbel(std::vector<double> maxima) {
  const LinearMoments moments = linear_moments(std::move(maxima));
  if (!differ(moments)) return std::nullopt;
  const double scale = moments.l2 / std::log(2.0);
  return ExtremeValue{moments.l1 - euler_gamma * scale, scale, 0};
}

std::optional<ExtremeValue> fitted_extreme_value(std::vector<double> maxima) {
  const LinearMoments moments = linear_moments(std::move(maxima));
  if (!differ(moments)) return std::nullopt;
  const double c = 2 / (3 + moments.l3 / moments.l2) - std::log(2.0) / std::log(3.0);
  const double k = 7.8590 * c + 2.9554 * c * c;
  if (std::abs(k) < no_shape) {
    const double scale = moments.l2 / std::log(2.0);
    return ExtremeValue{moments.l1 - euler_gamma * scale, scale, 0};
  }
  if (!(k > -1)) return std::nullopt;
  const double gamma = std::tgamma(1 + k);
  const double scale = moments.l2 * k / (-std::expm1(-k * std::log(2.0)) * gamma);
  return ExtremeValue{moments.l1 - scale * (1 - gamma) / k, scale, -k};
}

}  // namespace slackwater::twin
