#include "fields/base/numbers/normal_quantile.h"

#include <cmath>
#include <numbers>

#include "fields/base/check.h"

namespace slackwater {

double normal_quantile(double p) {
  expects(p > 0 && p < 1, "a probability between 0 and 1");
  if (p > 0.5) return -normal_quantile(1 - p);
  double z = 0;
  for (int i = 0; i < 100; ++i) {
    const double below = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    const double density = std::exp(-0.5 * z * z) * std::numbers::inv_sqrtpi / std::numbers::sqrt2;
    const double step = (below - p) / density;
    z -= step;
    if (std::abs(step) <= 1e-15 * std::abs(z)) break;
  }
  return z;
}

}  // namespace slackwater
