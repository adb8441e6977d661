#pragma once
#include <bit>
#include <cstdint>
#include <span>

namespace slackwater::twin {

/// exp(-x) for -700 <= x <= 700, without a branch: see `fading`.
[[nodiscard]] inline double fading_within(double x) noexcept {
  constexpr double per_ln2 = 1.4426950408889634, rounder = 0x1.8p52;
  constexpr double ln2_high = 0x1.62e42fee00000p-1, ln2_low = 0x1.a39ef35793c76p-33;
  const double rounded = -x * per_ln2 + rounder;  // n is in the low bits of it
  const double n = rounded - rounder;
  const double r = (-x - n * ln2_high) - n * ln2_low;
  double sum = 1.0 / 479001600;
  sum = sum * r + 1.0 / 39916800;
  sum = sum * r + 1.0 / 3628800;
  sum = sum * r + 1.0 / 362880;
  sum = sum * r + 1.0 / 40320;
  sum = sum * r + 1.0 / 5040;
  sum = sum * r + 1.0 / 720;
  sum = sum * r + 1.0 / 120;
  sum = sum * r + 1.0 / 24;
  sum = sum * r + 1.0 / 6;
  sum = sum * r + 1.0 / 2;
  sum = sum * r + 1;
  sum = sum * r + 1;
  return sum * std::bit_cast<double>((std::bit_cast<std::uint64_t>(rounded) + 1023) << 52U);
}

/// exp(-x), what is left of a beam after an optical way x: 0 beyond 700, and exp(700) at most of a
/// negative one. Relative error below 1e-14. By additions, products and bits alone, so that its
/// bits are those of every machine, which the C library does not promise.
///
///   exp(-x) = 2^n exp(r),  n the whole number next to -x/ln 2,  |r| <= ln 2 / 2
[[nodiscard]] inline double fading(double x) noexcept {
  if (!(x < 700)) return 0;
  return fading_within(x < -700 ? -700 : x);
}
/// The same of many, side by side, all of them from -700 to 700.
void fade(std::span<double> x) noexcept;

/// ln x of x > 0, finite: the exponent, and 2 artanh((m - 1)/(m + 1)) of what is left of it between
/// 0.7 and 1.4. Error below 1e-14. The same bits everywhere, too.
[[nodiscard]] inline double logarithm(double x) noexcept {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  auto exponent = static_cast<std::int64_t>(bits >> 52U) - 1023;
  double m = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFFU) | 0x3FF0000000000000U);
  if (m > 1.4142135623730951) {
    m *= 0.5;
    ++exponent;
  }
  const double z = (m - 1) / (m + 1), square = z * z;
  constexpr double odd[] = {1.0 / 17, 1.0 / 15, 1.0 / 13, 1.0 / 11, 1.0 / 9,
                            1.0 / 7,  1.0 / 5,  1.0 / 3,  1.0};
  double sum = 1.0 / 19;
  for (const double term : odd) sum = sum * square + term;
  return 2 * z * sum + static_cast<double>(exponent) * 0.6931471805599453;
}

/// (1 - exp(-k r)) / k: the length that is left of a way r through what takes k per metre.
/// r where k r is small. @param r  may be infinite where k is above 0
[[nodiscard]] inline double faded_length_m(double per_m, double way_m) noexcept {
  const double x = per_m * way_m;
  if (x < 1e-3 && x > -1e-3) return way_m * (1 - x / 2 * (1 - x / 3 * (1 - x / 4)));
  return (1 - fading(x)) / per_m;
}

}  // namespace slackwater::twin
