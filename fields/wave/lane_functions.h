#pragma once
// For sea_kernel.cc only, see lanes.h. Coefficients: near-minimax fits (Lawson's reweighted least
// squares on 400 Chebyshev nodes), errors measured over 200 001 arguments.
#include "fields/base/numbers/lanes.h"

namespace slackwater::SLACKWATER_KERNEL {

/// c[0] + c[1] x + ... by Horner's rule.
template <std::size_t terms, std::size_t n>
SLACKWATER_INLINE LanesIn<n> polynomial(const double (&c)[terms], const LanesIn<n>& x) {
  LanesIn<n> sum = LanesIn<n>::all(c[terms - 1]);
  for (std::size_t i = terms - 1; i-- > 0;) sum = sum * x + c[i];
  return sum;
}

template <std::size_t n>
struct SineCosine {
  LanesIn<n> sine;
  LanesIn<n> cosine;
};

/// sin and cos of an angle in turns, |turns| < 2^51. The whole turns are taken off exactly; the
/// quarter of the rest is at most pi/4, where eleven terms do, and is doubled twice. Error below
/// 2e-11.
template <std::size_t n>
SLACKWATER_INLINE SineCosine<n> sine_cosine_of_turns(const LanesIn<n>& turns) {
  constexpr double sine_terms[] = {1.5707963267881118, -0.645964096148441, 0.07969258275849184,
                                   -0.004681266466834211, 0.0001582067231721028};
  constexpr double cosine_terms[] = {0.9999999999999452,    -1.2337005501201508,
                                     0.2536695071534564,    -0.02086346799965334,
                                     0.0009191617248754451, -2.485094245048007e-05};
  const LanesIn<n> whole = (turns + LanesIn<n>::all(rounder)) - LanesIn<n>::all(rounder);
  const LanesIn<n> rest = turns - whole;
  const LanesIn<n> square = rest * rest;
  const LanesIn<n> one = LanesIn<n>::all(1.0);
  const LanesIn<n> two = LanesIn<n>::all(2.0);
  const LanesIn<n> quarter_sine = rest * polynomial(sine_terms, square);
  const LanesIn<n> quarter_cosine = polynomial(cosine_terms, square);
  const LanesIn<n> twice = two * quarter_sine;
  const LanesIn<n> half_sine = twice * quarter_cosine;
  const LanesIn<n> half_cosine = one - twice * quarter_sine;
  const LanesIn<n> twice_half = two * half_sine;
  return {twice_half * half_cosine, one - twice_half * half_sine};
}

template <std::size_t n>
struct PowerAndInverse {
  LanesIn<n> power;    ///< 2^x
  LanesIn<n> inverse;  ///< 2^-x
};

/// 2^x and 2^-x for -1000 <= x <= 1000 (a smaller x counts as -1000). With n the whole number next
/// to x and r = x - n, the even and the odd part of 2^r give 2^-r as well, without a division.
/// Relative error below 6e-11.
template <std::size_t n>
SLACKWATER_INLINE PowerAndInverse<n> powers_of_two(const LanesIn<n>& x) {
  constexpr double even_terms[] = {0.99999999995955, 0.2402265121358693, 0.009618025603893547,
                                   0.00015469731722908285};
  constexpr double odd_terms[] = {0.6931471805350247, 0.05550410976118876, 0.001333342263633098,
                                  1.5316463982531707e-05};
  const LanesIn<n> bounded = larger_of(x, LanesIn<n>::all(-1000.0));
  const LanesIn<n> shifted = bounded + LanesIn<n>::all(rounder);
  const LanesIn<n> rest = bounded - (shifted - LanesIn<n>::all(rounder));
  const LanesIn<n> square = rest * rest;
  const LanesIn<n> even = polynomial(even_terms, square);
  const LanesIn<n> odd = rest * polynomial(odd_terms, square);
  return {(even + odd) * whole_power_of_two(shifted), (even - odd) * whole_power_of_half(shifted)};
}

}  // namespace slackwater::SLACKWATER_KERNEL
