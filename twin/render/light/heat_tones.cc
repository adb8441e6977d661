#include "twin/render/light/heat_tones.h"

#include <algorithm>

namespace slackwater::twin {

std::vector<std::uint8_t> heat_tones(const InfraredFrame& heat) {
  std::vector<float> sorted = heat.apparent_k;
  const auto at = [&](double share) {
    const auto nth = sorted.begin() +
                     static_cast<std::ptrdiff_t>(share * static_cast<double>(sorted.size() - 1));
    std::nth_element(sorted.begin(), nth, sorted.end());
    return *nth;
  };
  const float coldest_k = at(0.01), warmest_k = std::max(at(0.99), coldest_k + 0.1F);
  std::vector<std::uint8_t> tones;
  tones.reserve(heat.apparent_k.size());
  for (const float one : heat.apparent_k)
    tones.push_back(static_cast<std::uint8_t>(
        255 * std::clamp((one - coldest_k) / (warmest_k - coldest_k), 0.0F, 1.0F)));
  return tones;
}

}  // namespace slackwater::twin
