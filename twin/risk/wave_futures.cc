#include "twin/risk/wave_futures.h"

#include <algorithm>
#include <cmath>

#include "fields/base/random.h"
#include "fields/wave/height_error.h"

namespace slackwater::twin {

WaveFutures::WaveFutures(std::uint64_t seed, std::size_t members, UtcTime from, UtcTime until)
    : from_(from) {
  const double hours = std::max(0.0, std::ceil(hours_between(from, until)));
  const auto nodes = static_cast<std::size_t>(hours) + 1;
  const double kept = std::exp(-1 / memory_h);
  const double fresh = std::sqrt(1 - kept * kept);
  for (std::size_t member = 1; member < members; ++member) {
    Rng random(seed, "risk/wave_height/" + std::to_string(member));
    std::vector<double>& path = paths_.emplace_back();
    path.reserve(nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      path.push_back(i == 0 ? random.normal() : kept * path.back() + fresh * random.normal());
  }
}

double WaveFutures::height_m(std::size_t member, double central_m, UtcTime time) const noexcept {
  if (member == 0) return central_m;
  const std::vector<double>& path = paths_[member - 1];
  const double lead_h =
      std::clamp(hours_between(from_, time), 0.0, static_cast<double>(path.size() - 1));
  const auto low = std::min(static_cast<std::size_t>(lead_h), path.size() - 1);
  const std::size_t high = std::min(low + 1, path.size() - 1);
  const double share = lead_h - static_cast<double>(low);
  // Between two nodes a mean of them is narrower than either: made as wide again.
  const double kept = high > low ? std::exp(-1 / memory_h) : 1;
  const double width =
      std::sqrt((1 - share) * (1 - share) + share * share + 2 * share * (1 - share) * kept);
  const double z = ((1 - share) * path[low] + share * path[high]) / width;
  const double height_m = central_m + wave_height_sigma_m(central_m, lead_h) * z;
  return std::isnan(central_m) ? central_m : std::max(0.0, height_m);
}

}  // namespace slackwater::twin
