#include "fields/current/column_modes.h"

namespace slackwater {

double mode_root(int n, double biot) noexcept {
  double low = n * constants::pi;
  double high = low + 0.5 * constants::pi;
  const double sign = n % 2 == 0 ? 1 : -1;  // of the cosine between them
  const auto signed_miss = [&](double x) { return sign * (x * std::sin(x) - biot * std::cos(x)); };
  // One sign change lies here for any biot > 0. The start has both limits, x = sqrt(biot) (n = 0)
  // and (n + 1/2) pi; Newton's steps from there are kept inside the bracket.
  constexpr double half_pi = 0.5 * constants::pi;
  double x = n == 0 ? half_pi * std::sqrt(biot / (biot + half_pi * half_pi))
                    : low + std::atan(biot / (low + 0.5 * half_pi));
  for (int i = 0; i < 60 && high - low > 1e-15 * high; ++i) {
    const double miss = signed_miss(x);
    (miss < 0 ? low : high) = x;
    const double slope = sign * (std::sin(x) + x * std::cos(x) + biot * std::sin(x));
    const double newton = x - miss / slope;
    const double next = newton >= low && newton <= high ? newton : 0.5 * (low + high);
    if (next == x) break;
    x = next;
  }
  return x;
}

}  // namespace slackwater
