#include "twin/render/light/lamp_veil.h"

#include <algorithm>
#include <cmath>

#include "twin/render/light/fading.h"

namespace slackwater::twin {
namespace {

/// Gauss and Legendre's, of -1 to 1; the other four lie across 0.
struct Node {
  double at;
  double weight;
};
constexpr std::array nodes{
    Node{0.1834346424956498, 0.3626837833783620}, Node{0.5255324099163290, 0.3137066458778873},
    Node{0.7966664774136267, 0.2223810344533745}, Node{0.9602898564975363, 0.1012285362903763}};

/// From where to where a ray is within a lamp's beam; nothing: to is not beyond from.
struct LitSpan {
  double from_m = 0;
  double to_m = 0;

  /// The beam is a cone, C = cos^2 of its half angle: along the ray, with w = s d - t the way from
  /// the lamp, within it (w . a)^2 - C w^2 = A s^2 + 2 B s + D > 0 and w . a > 0.
  LitSpan(const Lamp& lamp, const BeamEdge& edge, const Ray& ray, const Triple<double>& to_lamp,
          double range_m) noexcept
      : to_m(range_m) {
    const double along = dot(ray.direction, lamp.axis), before = -dot(to_lamp, lamp.axis);
    if (!(edge.dark > 0)) {
      // Half of space: where along s + before > 0.
      if (along > 0)
        from_m = std::max(from_m, -before / along);
      else if (along < 0)
        to_m = std::min(to_m, -before / along);
      else if (!(before > 0))
        to_m = from_m;
      return;
    }
    const double c = edge.dark * edge.dark;
    const double square = along * along - c;
    const double half = along * before + c * dot(to_lamp, ray.direction);
    const double whole = before * before - c * dot(to_lamp, to_lamp);
    const double root2 = half * half - square * whole;
    if (std::abs(square) < 1e-12 || !(root2 > 0)) {
      if (square < 0) to_m = from_m;
      return;
    }
    const double root = std::sqrt(root2);
    const double one = (-half - root) / square, two = (-half + root) / square;
    if (square < 0) {
      from_m = std::max(from_m, std::min(one, two));
      to_m = std::min(to_m, std::max(one, two));
      if (!(along * 0.5 * (one + two) + before > 0)) to_m = from_m;
    } else if (along > 0) {
      from_m = std::max(from_m, std::max(one, two));
    } else {
      to_m = std::min(to_m, std::min(one, two));
    }
  }
};

}  // namespace

LookPastLamp::LookPastLamp(const Lamp& lamp, const BeamEdge& edge, const Ray& ray,
                           double range_m) noexcept {
  const Triple<double> to_lamp = lamp.position_m - ray.from_m;
  const double nearest_m = dot(to_lamp, ray.direction);
  const Triple<double> off = to_lamp - nearest_m * ray.direction;
  constexpr double least_m = 1e-3;  // a lamp in the line of sight would blind it
  const double h2 = std::max(dot(off, off), least_m * least_m);
  const auto sum_at = [&](double s) {
    const double past = s - nearest_m;
    const double aside = std::sqrt(past * past + h2);
    return past >= 0 ? past + aside : h2 / (aside - past);
  };
  const LitSpan span(lamp, edge, ray, to_lamp, range_m);
  if (!(span.to_m > span.from_m)) return;
  is_dark = false;
  const double along = dot(ray.direction, lamp.axis), before = dot(to_lamp, lamp.axis);
  const double first = logarithm(sum_at(span.from_m));
  const double half = 0.5 * (logarithm(sum_at(span.to_m)) - first);
  std::array<double, 8> p;
  for (std::size_t i = 0; i < p.size(); ++i)
    p[i] = -(first + half * (1 + (i % 2 == 0 ? -1 : 1) * nodes[i / 2].at));
  fade(p);
  for (std::size_t i = 0; i < p.size(); ++i) {
    const double other = h2 / p[i];
    const double from_lamp_m = 0.5 * (p[i] + other), per_m = 1 / from_lamp_m;
    const double s = nearest_m + 0.5 * (p[i] - other);
    const double cosine = (s * along - before) * per_m;
    lit[i] = half * nodes[i / 2].weight * edge.lit(cosine) * per_m;
    way_m[i] = s + from_lamp_m;
  }
}

Bands LookPastLamp::sums(const Bands& c) const noexcept {
  Bands all{};
  if (is_dark) return all;
  std::array<double, 24> left;
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < lit.size(); ++i) left[8 * k + i] = c[k] * way_m[i];
  // A look without end goes farther than exp(-700).
  constexpr double most = 700;
  if (*std::max_element(left.begin(), left.end()) < most)
    fade(left);
  else
    for (double& one : left) one = fading(one);
  for (std::size_t k = 0; k < all.size(); ++k)
    for (std::size_t i = 0; i < lit.size(); ++i) all[k] += lit[i] * left[8 * k + i];
  return all;
}

double lamp_veil_along_per_m(const Lamp& lamp, const Ray& ray, double range_m,
                             double beam_attenuation_per_m) noexcept {
  return LookPastLamp(lamp, BeamEdge(lamp), ray, range_m)
      .sums({beam_attenuation_per_m, beam_attenuation_per_m, beam_attenuation_per_m})[green];
}

}  // namespace slackwater::twin
