#include "calibration/day/earned.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {

std::vector<double> weights_at(const Earned& earned, double lead_h) {
  const auto of_day = [&](std::size_t day) -> const Blend& {
    return day == 0 ? earned.blend : earned.later[day - 1];
  };
  const double last = static_cast<double>(earned.later.size());
  const double place = std::clamp(lead_h / 24.0 - 0.5, 0.0, last);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, earned.later.size());
  const double share = place - static_cast<double>(low);
  std::vector<double> weights;
  for (std::size_t c = 0; c < earned.blend.share.size(); ++c) {
    weights.push_back((1 - share) * of_day(low).share[c].weight +
                      share * of_day(high).share[c].weight);
  }
  return weights;
}

double sigma_of_blend(const Blend& blend, const std::vector<double>& weights, double own_sigma_m_s,
                      double merged_sigma_m_s) {
  if (!std::isfinite(merged_sigma_m_s)) return own_sigma_m_s;
  double merged = 0;
  for (std::size_t c = 0; c < weights.size(); ++c)
    if (blend.share[c].method == Method::merged) merged += weights[c];
  if (merged <= 0) return own_sigma_m_s;
  return std::sqrt((1 - merged) * own_sigma_m_s * own_sigma_m_s +
                   merged * merged_sigma_m_s * merged_sigma_m_s);
}

}  // namespace slackwater::calibration
