#pragma once
// For sea_kernel.cc only, see lanes.h. Coefficients: near-minimax fits (Lawson's reweighted least
// squares on 400 Chebyshev nodes), errors measured over 200 001 arguments.
#include "fields/wave/lanes.h"

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
/// 5e-13.
SLACKWATER_INLINE SineCosine sine_cosine_of_turns(const Lanes& turns) {
  constexpr double sine_terms[] = {1.5707963267948897,     -0.6459640975043226,
                                   0.07969262615599151,    -0.004681752593857604,
                                   0.00016042927727603806, -3.5564098275555665e-06};
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

/// 2^x for -1000 <= x <= 1000 (smaller x gives 2^-1000). Relative error below 2e-12.
SLACKWATER_INLINE Lanes power_of_two_real(const Lanes& x) {
  constexpr double terms[] = {
      1.000000000000028,      0.6931471805459338,    0.24022650695463418,
      0.05550410941208705,    0.009618129229174812,  0.0013333450563435421,
      0.00015403411204887115, 1.531008081501736e-05, 1.3264157333502283e-06};
  const Lanes bounded = larger_of(x, Lanes::all(-1000.0));
  const Lanes shifted = bounded + Lanes::all(rounder);
  const Lanes rest = bounded - (shifted - Lanes::all(rounder));
  return polynomial(terms, rest) * power_of_two(shifted);
}

}  // namespace slackwater::SLACKWATER_KERNEL
