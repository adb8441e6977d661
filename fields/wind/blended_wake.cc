#include "fields/wind/blended_wake.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/wind/gaussian_wake.h"

namespace slackwater {
namespace {

/// sigma/D where the core ends: the momentum of a Gaussian of depth 1 - sqrt(1 - Ct) for any Ct.
constexpr double width_at_core_end = 0.35355339059327373;
constexpr double larsen_anchor_diameters = 9.6;
constexpr double longest_near_wake = 30;
constexpr double shortest_near_wake = 0.01;
constexpr double widths_of_reach = 6;

double cube(double x) noexcept { return x * x * x; }

}  // namespace

BlendedWakeShape blended_wake_shape(double thrust_coefficient,
                                    double turbulence_intensity) noexcept {
  const double outflow = std::sqrt(1 - thrust_coefficient);
  const double mixing = 2.32 * turbulence_intensity + 0.154 * (1 - outflow);
  const double length = (1 + outflow) / (std::sqrt(2.0) * mixing);
  return {std::min(length, longest_near_wake), wake_growth(turbulence_intensity)};
}

BlendedWake::BlendedWake(double diameter_m, double thrust_coefficient,
                         BlendedWakeShape shape) noexcept
    : diameter_m_(diameter_m), thrust_coefficient_(thrust_coefficient), shape_(shape) {
  shape_.near_wake_length = std::max(shape_.near_wake_length, shortest_near_wake);
  const double outflow = std::sqrt(1 - thrust_coefficient);
  induction_deficit_ = 1 - outflow;
  initial_core_ = 0.5 * std::sqrt((1 + outflow) / (2 * outflow));
  far_start_ = std::max(larsen_anchor_diameters, 2 * shape_.near_wake_length);
  const double to_far = far_start_ - shape_.near_wake_length;
  const double width_there = width_at_core_end + shape_.growth * to_far;
  cube_growth_ = (cube(width_there) - cube(width_at_core_end)) / to_far;
  // The cube root is concave: its tangent at x_f is above it everywhere, and above the blend.
  const double slope = cube_growth_ / (3 * width_there * width_there);
  tangent_slope_ = widths_of_reach * slope;
  tangent_m_ = widths_of_reach * diameter_m * (width_there - slope * far_start_);
  shortest_reach_m_ = diameter_m * (initial_core_ + widths_of_reach * width_at_core_end);
}

BlendedWake::Profile BlendedWake::near_profile(double x) const noexcept {
  // With core radius a, depth C and edge width s (diameters), momentum over 2 pi D^2 reads
  //   a^2 C(1-C)/2 + a s [C sqrt(pi/2) - C^2 sqrt(pi)/2] + s^2 [C - C^2/2] = Ct/16.
  const double core = initial_core_ * std::max(0.0, 1 - x / shape_.near_wake_length);
  const double depth = induction_deficit_;
  const double edge =
      depth * std::sqrt(constants::pi / 2) - 0.5 * depth * depth * std::sqrt(constants::pi);
  const double square = depth - 0.5 * depth * depth;
  const double missing = thrust_coefficient_ / 16 - 0.5 * core * core * depth * (1 - depth);
  const double linear = core * edge;
  const double width =
      2 * missing / (linear + std::sqrt(linear * linear + 4 * square * std::max(0.0, missing)));
  return {depth, core, width};
}

double BlendedWake::far_width(double x) const noexcept {
  return std::cbrt(cube(width_at_core_end) + cube_growth_ * (x - shape_.near_wake_length));
}

BlendedWake::Profile BlendedWake::profile(double x) const noexcept {
  if (x <= shape_.near_wake_length) return near_profile(x);
  double width = far_width(x);
  if (x < far_start_) {
    const double t = (x - shape_.near_wake_length) / (far_start_ - shape_.near_wake_length);
    const double weight = t * t * (3 - 2 * t);
    const double straight = width_at_core_end + shape_.growth * (x - shape_.near_wake_length);
    width = straight + weight * (width - straight);
  }
  return {gaussian_axis_deficit(thrust_coefficient_, width), 0, width};
}

double BlendedWake::deficit(double downstream_m, double radius_m) const noexcept {
  const Profile at = profile(downstream_m / diameter_m_);
  const double beyond = radius_m / diameter_m_ - at.core;
  if (beyond <= 0) return at.axis_deficit;
  if (!(beyond < widths_of_reach * at.width)) return 0;
  const double ratio = beyond / at.width;
  return at.axis_deficit * std::exp(-0.5 * ratio * ratio);
}

double BlendedWake::edge_m(double downstream_m) const noexcept {
  const Profile at = profile(downstream_m / diameter_m_);
  return diameter_m_ * (at.core + 2 * at.width);
}

}  // namespace slackwater
