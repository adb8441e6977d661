#include "twin/curve/uniform_axis.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {

std::optional<UniformAxis> uniform_axis_through(std::span<const double> points, std::size_t most) {
  expects(points.size() >= 2, "an axis has two ends");
  const double length = points.back() - points.front();
  for (std::size_t steps = points.size() - 1; steps < most; ++steps) {
    const UniformAxis axis{points.front(), length / static_cast<double>(steps), steps + 1};
    const auto stands_on_it = [&](double point) {
      const double place = (point - axis.first) / axis.step;
      return std::abs(place - std::round(place)) < 1e-6;  // a share of a step: decimals round
    };
    if (std::all_of(points.begin(), points.end(), stands_on_it)) return axis;
  }
  return std::nullopt;
}

std::vector<double> on_axis(const UniformAxis& axis, std::span<const double> x,
                            std::span<const double> y) {
  expects(x.size() == y.size() && x.size() >= 2, "a broken line has two points at least");
  std::vector<double> values(axis.count);
  for (std::size_t i = 0; i < axis.count; ++i) {
    const double at = axis.at(i);
    const auto above = static_cast<std::size_t>(
        std::clamp(std::upper_bound(x.begin(), x.end(), at) - x.begin(), std::ptrdiff_t{1},
                   static_cast<std::ptrdiff_t>(x.size()) - 1));
    const double share = (at - x[above - 1]) / (x[above] - x[above - 1]);
    // A place that is a point's but for the rounding of decimals has that point's very value.
    if (share < 1e-9)
      values[i] = y[above - 1];
    else if (share > 1 - 1e-9)
      values[i] = y[above];
    else
      values[i] = y[above - 1] + share * (y[above] - y[above - 1]);
  }
  return values;
}

}  // namespace slackwater::twin
