#include "twin/thruster/open_water.h"

#include <algorithm>
#include <cmath>

#include "twin/thruster/actuator_disc.h"

namespace slackwater::twin {

/// On each straight piece K_T = a + b J the thrust is a w^2 + b c w, with c = J w, which the water
/// sets: a quadratic. Which piece it is follows from K_T/J^2 = T/c^2, which falls with J (the
/// reader sees to it).
double shaft_for(const OpenWater& water, double thrust_n, double advance_m_s) {
  if (!(std::abs(thrust_n) > 0)) return 0;
  const bool is_astern = thrust_n < 0;
  const UniformAxis& axis = is_astern ? water.astern_ratio : water.ahead_ratio;
  const double* const table =
      water.step.data() + (is_astern ? 4 * water.ahead_ratio.count : std::size_t{0});
  const double size_n = std::abs(thrust_n);
  const double way = way_of(thrust_n);
  const auto k_at = [&](std::size_t place) { return table[4 * place]; };
  const double c = water.ratio_per_turn() * way * advance_m_s;
  if (!(c > 0)) return way * std::sqrt(size_n / k_at(0));
  const auto gives_it = [&](std::size_t place) {
    const double ratio = axis.at(place);
    return k_at(place) * c * c >= size_n * ratio * ratio;
  };
  // The last place that gives as much or more: the first one does, at J = 0.
  std::size_t low = 0, high = axis.count;
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    (gives_it(middle) ? low : high) = middle;
  }
  if (low + 1 == axis.count) return way * std::sqrt(size_n / k_at(low));
  const double slope = (k_at(low + 1) - k_at(low)) / axis.step;
  const double at_rest = k_at(low) - slope * axis.at(low);
  const double linear = slope * c;
  const double root = std::sqrt(linear * linear + 4 * at_rest * size_n);
  // Of the two forms of the root the one that takes no difference of like numbers.
  return way * (linear > 0 ? 2 * size_n / (linear + root) : (root - linear) / (2 * at_rest));
}

}  // namespace slackwater::twin
