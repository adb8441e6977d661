#include "fields/service/speed_quantiles.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {
namespace {

/// A polynomial, its highest power first.
template <std::size_t n>
double polynomial(double x, const std::array<double, n>& coefficients) noexcept {
  double sum = 0;
  for (const double c : coefficients) sum = sum * x + c;
  return sum;
}

/// exp(-z) I_0(z), z >= 0, to 2e-7.
double scaled_bessel_i0(double z) noexcept {
  constexpr double joint = 3.75;
  if (z < joint) {
    const double t = z / joint;
    return std::exp(-z) * polynomial(t * t, std::array{0.0045813, 0.0360768, 0.2659732, 1.2067492,
                                                       3.0899424, 3.5156229, 1.0});
  }
  return polynomial(joint / z,
                    std::array{0.00392377, -0.01647633, 0.02635537, -0.02057706, 0.00916281,
                               -0.00157565, 0.00225319, 0.01328592, 0.39894228}) /
         std::sqrt(z);
}

/// Rice's density of the speed over sigma.
double density(double t, double a) noexcept {
  return t * std::exp(-(t - a) * (t - a) / 2) * scaled_bessel_i0(a * t);
}

}  // namespace

SpeedQuantiles speed_quantiles(double central_m_s, double sigma_m_s) noexcept {
  assert(central_m_s >= 0 && sigma_m_s >= 0);
  if (!(sigma_m_s > 0)) return {central_m_s, central_m_s, central_m_s};
  const double a = central_m_s / sigma_m_s;
  constexpr double far = 40;
  if (a > far) {  // a normal, to 1/a^2
    const double middle = central_m_s + sigma_m_s / (2 * a);
    const double reach = constants::normal_p90 * sigma_m_s;
    return {middle - reach, middle, middle + reach};
  }
  // The integral, step by step over all that counts, by the trapezoidal rule.
  constexpr double reach = 6;
  constexpr double step = 0.01;
  constexpr std::array<double, 3> wanted{0.1, 0.5, 0.9};
  std::array<double, 3> found{};
  std::size_t next = 0;
  double t = std::max(0.0, a - reach);
  double here = density(t, a);
  double sum = 0;
  while (next < wanted.size() && t < a + reach) {
    const double there = density(t + step, a);
    const double slice = (here + there) / 2 * step;
    while (next < wanted.size() && sum + slice >= wanted[next]) {
      found[next] = t + step * (wanted[next] - sum) / slice;
      ++next;
    }
    sum += slice;
    t += step;
    here = there;
  }
  return {found[0] * sigma_m_s, found[1] * sigma_m_s, found[2] * sigma_m_s};
}

}  // namespace slackwater
