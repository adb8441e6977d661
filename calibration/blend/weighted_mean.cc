#include "calibration/blend/weighted_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/check.h"

namespace slackwater::calibration {

WeightedMean weighted_mean(std::span<const double> x, std::span<const double> g) {
  expects(x.size() == g.size(), "a weighted mean has a weight for each term");
  WeightedMean result{0.0, std::numeric_limits<double>::infinity(), x.empty() ? 0.0 : 1.0};
  double sum = 0;
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += g[i];
    squares += g[i] * g[i];
    result.mean += g[i] * x[i];
  }
  if (!(sum > 0)) return result;
  result.mean /= sum;
  double variance = 0;
  double neighbours = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double departure = x[i] - result.mean;
    variance += g[i] * departure * departure;
    if (i > 0) neighbours += std::sqrt(g[i] * g[i - 1]) * departure * (x[i - 1] - result.mean);
  }
  const double r = variance > 0 ? std::clamp(neighbours / variance, 0.0, 0.9) : 0.0;
  const double independent = sum * sum / squares * (1.0 - r) / (1.0 + r);
  if (x.size() < 2 || independent < 1.5) return result;
  result.independent = independent;
  result.standard_error = std::sqrt(variance / sum / (independent - 1.0));
  return result;
}

}  // namespace slackwater::calibration
