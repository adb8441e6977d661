#include "twin/render/light/sun_glint.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/render/light/fading.h"

namespace slackwater::twin {

double mean_square_slope(double wind_m_s) noexcept { return 0.003 + 0.00512 * wind_m_s; }

double mirrored_share(double cosine) noexcept {
  const double off = 1 - cosine, square = off * off;
  return 0.02 + 0.98 * square * square * off;
}

double sun_glint_per_sr(const Triple<double>& to_eye, const Triple<double>& to_sun,
                        const Triple<double>& normal, double slope) noexcept {
  constexpr double flattest = 0.05;  // cos 87 degrees
  if (dot(to_sun, normal) <= 0) return 0;
  const Triple<double> middle = to_eye + to_sun;
  const Triple<double> facet = (1 / std::max(1e-9, length_of(middle))) * middle;
  const double upright = dot(facet, normal);  // cos beta
  if (upright <= 0) return 0;
  const double square = upright * upright, tangent_square = (1 - square) / square;
  const double many = fading(tangent_square / slope) / (constants::pi * slope);
  return mirrored_share(dot(facet, to_sun)) * many /
         (4 * std::max(flattest, dot(to_eye, normal)) * square * square);
}

}  // namespace slackwater::twin
