#include "fields/current/local_flow.h"

#include <algorithm>
#include <cmath>

namespace slackwater {
namespace {

/// s^2 per Cd d x of a wake whose half-width is 0.25 sqrt(Cd d x): 0.0625/(2 ln 2).
constexpr double width_growth = 0.045084220027780106;
constexpr double root_2 = 1.4142135623730951;
constexpr double root_pi = 1.772453850905516;

/// 0 up to 0, 1 from 1 on, without a corner.
double smooth_step(double t) noexcept {
  const double held = std::clamp(t, 0.0, 1.0);
  return held * held * (3 - 2 * held);
}

/// By real numbers: the library's complex ones spend most of their time on infinities.
double length_of(Horizontal v) noexcept {
  return std::sqrt(v.real() * v.real() + v.imag() * v.imag());
}

/// Position in the frame of the stream: x down it, y to its left.
Horizontal in_stream_frame(Horizontal from_axis_m, Horizontal current_m_s,
                           double speed_m_s) noexcept {
  const double cosine = current_m_s.real() / speed_m_s, sine = current_m_s.imag() / speed_m_s;
  const double east_m = from_axis_m.real(), north_m = from_axis_m.imag();
  return {east_m * cosine + north_m * sine, north_m * cosine - east_m * sine};
}

}  // namespace

Horizontal potential_flow_around_pile(const Pile& pile, Horizontal current_m_s,
                                      Horizontal from_axis_m) noexcept {
  const double speed_m_s = length_of(current_m_s);
  if (!(speed_m_s > 0)) return current_m_s;
  const Horizontal at = in_stream_frame(from_axis_m, current_m_s, speed_m_s);
  // R/xi, its square, and w = 1 - R^2/xi^2 of which U conj(w) is wanted.
  const double scale = 0.5 * pile.diameter_m / std::norm(at);
  const double x = scale * at.real(), y = -scale * at.imag();
  const double real = 1 - (x * x - y * y), imaginary = -2 * x * y;
  const double east_m_s = current_m_s.real(), north_m_s = current_m_s.imag();
  return {east_m_s * real + north_m_s * imaginary, north_m_s * real - east_m_s * imaginary};
}

Horizontal wake_behind_pile(const Pile& pile, Horizontal current_m_s,
                            Horizontal from_axis_m) noexcept {
  const double speed_m_s = length_of(current_m_s);
  if (!(speed_m_s > 0)) return {0, 0};
  const Horizontal at = in_stream_frame(from_axis_m, current_m_s, speed_m_s);
  const double x = at.real() / pile.diameter_m;
  const double y = at.imag() / pile.diameter_m;
  if (x <= 0) return {0, 0};
  const double least_width = pile.drag_coefficient / root_pi;
  const double width =
      std::sqrt(least_width * least_width + width_growth * pile.drag_coefficient * x);
  const double depth = (1 - std::sqrt(1 - least_width / width)) / root_2;
  const double off_wall = length_of(at) / pile.diameter_m - 0.5;
  const double fade = smooth_step(x) * smooth_step(off_wall);
  return -fade * depth * std::exp(-0.5 * y * y / (width * width)) * current_m_s;
}

std::optional<Horizontal> flow_around_pile(const Pile& pile, Horizontal current_m_s,
                                           Horizontal from_axis_m) noexcept {
  if (!(pile.diameter_m > 0)) return current_m_s;
  if (!(length_of(from_axis_m) >= 0.5 * pile.diameter_m)) return std::nullopt;
  return potential_flow_around_pile(pile, current_m_s, from_axis_m) +
         wake_behind_pile(pile, current_m_s, from_axis_m);
}

}  // namespace slackwater
