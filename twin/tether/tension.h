#pragma once
#include <array>
#include <cstddef>

#include "fields/base/numbers/real.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// How the stretch of each segment depends on the tensions: `diagonal` T_j + `beside` (T_j-1 and
/// T_j+1) = `stretch_m`, symmetric and positive definite; `beside[j]` couples segments j and j + 1.
template <typename Real>
struct TensionSystem {
  std::array<Real, tether_segments> diagonal{};
  std::array<Real, tether_segments - 1> beside{};
  std::array<Real, tether_segments> stretch_m{};
};

/// The system of the segments that pull, the others having no tension: elimination without pivoting
/// (Thomas).
template <typename Real>
[[nodiscard]] std::array<Real, tether_segments> tensions_of(
    const TensionSystem<Real>& s, const std::array<Real, tether_segments>& pulls) {
  std::array<Real, tether_segments> upper{}, tension{};
  Real left{}, beside{};
  for (std::size_t j = 0; j < tether_segments; ++j) {
    const Real idle = 1.0 - pulls[j];
    if (j > 0) beside = (pulls[j - 1] * pulls[j]) * s.beside[j - 1];
    const Real pivot =
        1.0 / (pulls[j] * s.diagonal[j] + idle - (j > 0 ? beside * upper[j - 1] : left));
    if (j + 1 < tether_segments) upper[j] = (pulls[j] * pulls[j + 1]) * s.beside[j] * pivot;
    tension[j] = (pulls[j] * s.stretch_m[j] - (j > 0 ? beside * tension[j - 1] : left)) * pivot;
  }
  for (std::size_t j = tether_segments - 1; j-- > 0;)
    tension[j] = tension[j] - upper[j] * tension[j + 1];
  return tension;
}

/// Tensions that pull where the line would else be too long and are nothing where it is slack:
///
///   T >= 0,  S T >= g,  T (S T - g) = 0.
///
/// A line cannot push. Which segments pull is guessed from the tensions `before` and mended twice:
/// a primal-dual active set method, which ends for matrices of this kind (Hintermueller, Ito and
/// Kunisch, SIAM J. Optim. 13, 2003). What two mendings leave undone, in one step of some hundreds
/// when a line is thrown about, is a few newtons in one segment.
template <typename Real>
[[nodiscard]] std::array<Real, tether_segments> pulling_tensions(
    const TensionSystem<Real>& s, const std::array<Real, tether_segments>& before,
    int mendings = 2) {
  const Real none = Real{} + 0.0, one = Real{} + 1.0;
  std::array<Real, tether_segments> pulls{}, tension{};
  for (std::size_t j = 0; j < tether_segments; ++j) pulls[j] = select(before[j] > 0.0, one, none);
  for (int mending = 0;; ++mending) {
    tension = tensions_of(s, pulls);
    if (mending == mendings) break;
    for (std::size_t j = 0; j < tether_segments; ++j) {
      Real over = s.diagonal[j] * tension[j] - s.stretch_m[j];
      if (j > 0) over = over + s.beside[j - 1] * tension[j - 1];
      if (j + 1 < tether_segments) over = over + s.beside[j] * tension[j + 1];
      // One of the two is nothing, but for rounding.
      pulls[j] = select(pulls[j] > 0.5, select(tension[j] > 0.0, one, none),
                        select(over < 0.0, one, none));
    }
  }
  for (Real& t : tension) t = larger_of(t, none);
  return tension;
}

}  // namespace slackwater::twin
