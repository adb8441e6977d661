#include "fields/current/column_modes.h"

namespace slackwater {

double mode_root(int n, double biot) noexcept {
  double low = n * constants::pi;
  double high = low + 0.5 * constants::pi;
  const double sign = n % 2 == 0 ? 1 : -1;  // of the cosine between them
  const auto signed_miss = [&](double x) { return sign * (x * std::sin(x) - biot * std::cos(x)); };
  // One sign change lies here for any biot > 0: a few halvings, then Newton kept inside the bracket.
  double x = 0.5 * (low + high);
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
