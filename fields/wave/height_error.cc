#include "fields/wave/height_error.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace slackwater {
namespace {

constexpr std::array<double, 4> heights_m{1, 2, 4, 6};
constexpr std::array<double, 5> leads_h{12, 24, 36, 48, 72};
constexpr std::array<std::array<double, 5>, 4> sigmas_m{{{0.34, 0.36, 0.37, 0.39, 0.43},
                                                         {0.42, 0.45, 0.50, 0.54, 0.66},
                                                         {0.66, 0.76, 0.85, 0.94, 1.08},
                                                         {0.83, 0.94, 1.05, 1.16, 1.37}}};

/// The place of x among ascending knots, held at their ends.
struct Between {
  std::size_t index = 0;
  double share = 0;  ///< of the knot after it
};

template <std::size_t n>
Between between(double x, const std::array<double, n>& knots) {
  const double held = std::clamp(x, knots.front(), knots.back());
  std::size_t i = 0;
  while (i + 2 < n && held > knots[i + 1]) ++i;
  return {i, (held - knots[i]) / (knots[i + 1] - knots[i])};
}

}  // namespace

double wave_height_sigma_m(double height_m, double lead_h) noexcept {
  const Between h = between(height_m, heights_m);
  const Between l = between(lead_h, leads_h);
  const auto at = [&](std::size_t row) {
    return (1 - l.share) * sigmas_m[row][l.index] + l.share * sigmas_m[row][l.index + 1];
  };
  const double sigma_m = (1 - h.share) * at(h.index) + h.share * at(h.index + 1);
  return std::min(1.0, std::max(0.0, height_m) / heights_m.front()) * sigma_m;
}

namespace height_error {

double of_sigma(double height_m, double sigma_m) noexcept {
  const double variation = sigma_m / (height_m + shift_m);
  return std::sqrt(std::log1p(variation * variation));
}

double of_product(double height_m, double lead_h) noexcept {
  if (std::isnan(height_m)) return height_m;
  const double at_m = std::max(height_m, shift_m);
  return of_sigma(at_m, wave_height_sigma_m(at_m, lead_h));
}

double of_kept(double lead_h) noexcept {
  return 0.48 * std::sqrt(-std::expm1(-std::max(0.0, lead_h) / 26));
}

double of_computed(double wind_sigma_m_s, bool without_swell) noexcept {
  return std::hypot(per_wind * wind_sigma_m_s, without_swell ? 0.30 : 0.20);
}

}  // namespace height_error

}  // namespace slackwater
