#pragma once
// For sea_kernel.cc only, see lanes.h. Coefficients: near-minimax fits (Lawson's reweighted least
// squares on 400 Chebyshev nodes), errors measured over 200 001 arguments.
#include "fields/base/lanes.h"

namespace slackwater::SLACKWATER_KERNEL {

/// c[0] + c[1] x + ... by Horner's rule.
template <std::size_t terms>
SLACKWATER_INLINE Lanes polynomial(const double (&c)[terms], const Lanes& x) {
  Lanes sum = Lanes::all(c[terms - 1]);
  for (std::size_t i = terms - 1; i-- > 0;) sum = sum * x + Lanes::all(c[i]);
  return sum;
}

struct SineCosine {
  Lanes sine;
  Lanes cosine;
};

/// sin and cos of an angle in turns, |turns| < 2^51. The whole turns are taken off exactly; the
/// quarter of the rest is at most pi/4, where eleven terms do, and is doubled twice. Error below
/// 2e-11.
SLACKWATER_INLINE SineCosine sine_cosine_of_turns(const Lanes& turns) {
  constexpr double sine_terms[] = {1.5707963267881118, -0.645964096148441, 0.07969258275849184,
                                   -0.004681266466834211, 0.0001582067231721028};
  constexpr double cosine_terms[] = {0.9999999999999452,    -1.2337005501201508,
                                     0.2536695071534564,    -0.02086346799965334,
                                     0.0009191617248754451, -2.485094245048007e-05};
  const Lanes whole = (turns + Lanes::all(rounder)) - Lanes::all(rounder);
  const Lanes rest = turns - whole;
  const Lanes square = rest * rest;
  const Lanes one = Lanes::all(1.0);
  const Lanes two = Lanes::all(2.0);
  const Lanes quarter_sine = rest * polynomial(sine_terms, square);
  const Lanes quarter_cosine = polynomial(cosine_terms, square);
  const Lanes twice = two * quarter_sine;
  const Lanes half_sine = twice * quarter_cosine;
  const Lanes half_cosine = one - twice * quarter_sine;
  const Lanes twice_half = two * half_sine;
  return {twice_half * half_cosine, one - twice_half * half_sine};
}

struct PowerAndInverse {
  Lanes power;    ///< 2^x
  Lanes inverse;  ///< 2^-x
};

/// 2^x and 2^-x for -1000 <= x <= 1000 (a smaller x counts as -1000). With n the whole number next
/// to x and r = x - n, the even and the odd part of 2^r give 2^-r as well, without a division.
/// Relative error below 6e-11.
SLACKWATER_INLINE PowerAndInverse powers_of_two(const Lanes& x) {
  constexpr double even_terms[] = {0.99999999995955, 0.2402265121358693, 0.009618025603893547,
                                   0.00015469731722908285};
  constexpr double odd_terms[] = {0.6931471805350247, 0.05550410976118876, 0.001333342263633098,
                                  1.5316463982531707e-05};
  const Lanes bounded = larger_of(x, Lanes::all(-1000.0));
  const Lanes shifted = bounded + Lanes::all(rounder);
  const Lanes rest = bounded - (shifted - Lanes::all(rounder));
  const Lanes square = rest * rest;
  const Lanes even = polynomial(even_terms, square);
  const Lanes odd = rest * polynomial(odd_terms, square);
  return {(even + odd) * whole_power_of_two(shifted), (even - odd) * whole_power_of_half(shifted)};
}

}  // namespace slackwater::SLACKWATER_KERNEL
