#include "twin/inspection/instrument/bend.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {
namespace {

/// The normal equations of dn = S dx for the symmetric S = [xx xy; xy yy].
struct Fit {
  double x_x = 0, x_y = 0, y_y = 0;  // sums of the ways' products
  Triple<double> right;              // of the equations for xx, xy, yy

  void add(double x, double y, double turn_x, double turn_y) noexcept {
    x_x += x * x;
    x_y += x * y;
    y_y += y * y;
    right = right + Triple<double>{x * turn_x, y * turn_x + x * turn_y, y * turn_y};
  }
  /// xx, xy, yy by Cramer's rule; what the ways say nothing of is 0.
  [[nodiscard]] Triple<double> solved() const noexcept {
    const double slight = 1e-9 * (x_x + y_y);
    if (!(slight > 0)) return {};
    const Triple<double> a{x_x + slight, x_y, 0}, b{x_y, x_x + y_y, x_y}, c{0, x_y, y_y + slight};
    const double all = dot(a, cross(b, c));
    return {dot(right, cross(b, c)) / all, dot(right, cross(c, a)) / all,
            dot(right, cross(a, b)) / all};
  }
};

bool goes_on(const Patch& from, const Patch& to, const Triple<double>& way_m) noexcept {
  constexpr double least_cosine = 0.5, steepest = 0.6;
  return dot(from.normal, to.normal) > least_cosine &&
         std::abs(dot(way_m, from.normal)) <= steepest * length_of(way_m);
}

}  // namespace

Bend bend_at(const Surface& surface, const ViewIndex& index, std::uint32_t patch) {
  const Patch& here = surface.patches[patch];
  const double reach_m = 1.6 * std::max<double>(here.width_m, here.height_m);
  const Triple<double>& n = here.normal;
  const Triple<double> aside =
      std::abs(n.z) < 0.7 ? Triple<double>{0, 0, 1} : Triple<double>{1, 0, 0};
  Triple<double> x = cross(aside, n);
  x = (1 / length_of(x)) * x;
  const Triple<double> y = cross(n, x);
  Fit fit;
  for (const ViewIndex::Block& block : index.blocks) {
    if (length_of(block.centre_m - here.centre_m) - block.radius_m > reach_m) continue;
    for (std::uint32_t i = block.first; i < block.end; ++i) {
      const Patch& there = surface.patches[index.patches[i]];
      const Triple<double> way_m = there.centre_m - here.centre_m;
      if (index.patches[i] == patch || length_of(way_m) > reach_m) continue;
      if (goes_on(here, there, way_m))
        fit.add(dot(way_m, x), dot(way_m, y), dot(there.normal, x), dot(there.normal, y));
    }
  }
  const Triple<double> s = fit.solved();
  const double mean = 0.5 * (s.x + s.z), half = std::hypot(0.5 * (s.x - s.z), s.y);
  const double angle = 0.5 * std::atan2(2 * s.y, s.x - s.z);
  const Triple<double> first = std::cos(angle) * x + std::sin(angle) * y;
  return {n, first, cross(n, first), mean + half, mean - half};
}

}  // namespace slackwater::twin
