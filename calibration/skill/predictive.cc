#include "calibration/skill/predictive.h"

#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::calibration {

ComponentScore score_of_normal(double mean, double sigma, double truth) noexcept {
  if (sigma <= 0) {
    const double side = truth == mean ? 0.5 : (truth > mean ? 1.0 : 0.0);
    return {side, std::abs(truth - mean)};
  }
  const double z = (truth - mean) / sigma;
  const double error_function = std::erf(z / std::sqrt(2.0));  // 2 Phi(z) - 1
  const double density = std::exp(-0.5 * z * z) / std::sqrt(2.0 * constants::pi);
  return {0.5 * (1.0 + error_function),
          sigma * (z * error_function + 2.0 * density - 1.0 / std::sqrt(constants::pi))};
}

}  // namespace slackwater::calibration
