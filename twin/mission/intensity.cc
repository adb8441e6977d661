#include "twin/mission/intensity.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

const char* name_of(PassOrder order) noexcept {
  return order == PassOrder::as_laid ? "as_laid" : "coarse_to_fine";
}

Intensity read_intensity(const Config& config) {
  Intensity intensity;
  intensity.density = config.optional_number("density", {0.01, 1}).value_or(intensity.density);
  if (const auto order = config.optional_text("order")) {
    if (*order == name_of(PassOrder::coarse_to_fine))
      intensity.order = PassOrder::coarse_to_fine;
    else if (*order != name_of(PassOrder::as_laid))
      config.refuse("order", "found " + *order + ", expected as_laid or coarse_to_fine");
  }
  return intensity;
}

YamlValue value_of(const Intensity& intensity) {
  return YamlValue()
      .put("density", std::round(1e6 * intensity.density) / 1e6)
      .put("order", name_of(intensity.order));
}

Intensity thinned(const Intensity& own, const Intensity& by) noexcept {
  return {own.density * by.density, by.density < 1 ? by.order : own.order};
}

int passes_at(int passes, double density) noexcept {
  // Less what products of shares are off by rounding.
  return std::clamp(static_cast<int>(std::ceil(passes * density - 1e-6)), 1, passes);
}

std::vector<int> flown_order(int passes, PassOrder order) {
  std::vector<int> flown;
  const int stride = order == PassOrder::as_laid ? 1 : 2;
  for (int pass = 0; pass < passes; pass += stride) flown.push_back(pass);
  if (stride == 1) return flown;
  for (int pass = passes - 1; pass >= 0; --pass)
    if (pass % 2 == 1) flown.push_back(pass);
  return flown;
}

}  // namespace slackwater::twin
