#include "calibration/solve/residual_memory.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

/// Sums the products of neighbours along one axis.
struct LagOne {
  Horizontal product{};
  double first = 0;
  double second = 0;
  std::size_t n = 0;

  void add(Horizontal a, Horizontal b) {
    product += b * std::conj(a);
    first += std::norm(a);
    second += std::norm(b);
    ++n;
  }
  [[nodiscard]] double correlation() const {
    if (n == 0 || !(first > 0) || !(second > 0)) return 0.0;
    const double c = std::abs(product) / std::sqrt(first * second);
    const double noise = 2.0 / std::sqrt(static_cast<double>(n));
    return c <= noise ? 0.0 : std::min(c, 0.999);
  }
};

double worth(double count, double correlation) {
  return std::max(1.0, count * (1.0 - correlation) / (1.0 + correlation));
}

}  // namespace

ResidualMemory residual_memory(const VectorColumn& residual) {
  LagOne in_time;
  LagOne in_depth;
  std::size_t pairs = 0;
  std::vector<bool> time_seen(residual.times());
  std::vector<bool> level_seen(residual.levels());
  for (std::size_t t = 0; t < residual.times(); ++t) {
    for (std::size_t k = 0; k < residual.levels(); ++k) {
      if (!residual.has(t, k)) continue;
      ++pairs;
      time_seen[t] = true;
      level_seen[k] = true;
      const Horizontal here = residual.value[residual.offset(t, k)];
      if (t > 0 && residual.has(t - 1, k))
        in_time.add(residual.value[residual.offset(t - 1, k)], here);
      if (k > 0 && residual.has(t, k - 1))
        in_depth.add(residual.value[residual.offset(t, k - 1)], here);
    }
  }
  ResidualMemory memory;
  if (pairs == 0) return memory;
  memory.time_correlation = in_time.correlation();
  memory.depth_correlation = in_depth.correlation();
  const auto times = static_cast<double>(std::count(time_seen.begin(), time_seen.end(), true));
  const auto levels = static_cast<double>(std::count(level_seen.begin(), level_seen.end(), true));
  const double share = worth(times, memory.time_correlation) / times *
                       worth(levels, memory.depth_correlation) / levels;
  memory.effective_pairs = std::max(1.0, share * static_cast<double>(pairs));
  return memory;
}

}  // namespace slackwater::calibration
