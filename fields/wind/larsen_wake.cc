#include "fields/wind/larsen_wake.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater {
namespace {

/// Radius of the wake (in diameters) where it was measured, and how far downstream that is.
struct Anchor {
  double distance;
  double radius;
};

Anchor measured(LarsenRadius anchor, double ct, double ti, double hub_height_diameters) noexcept {
  if (anchor == LarsenRadius::ewts_1996) {
    const double neutral = std::max(1.08, 1.08 + 21.7 * (ti - 0.05));
    return {9.5, 0.5 * (neutral + std::min(hub_height_diameters, neutral))};
  }
  return {9.6, 0.435449861 * std::exp(0.797853685 * ct * ct - 0.124807893 * ct + 0.136821858) *
                   (15.6298 * ti + 1)};
}

}  // namespace

LarsenWake::LarsenWake(double diameter_m, double thrust_coefficient, double turbulence_intensity,
                       LarsenRadius anchor, double hub_height_m) noexcept {
  const double ct = thrust_coefficient;
  const double thrust_area_m2 = ct * 0.25 * constants::pi * diameter_m * diameter_m;
  const double rotor_ratio = std::sqrt(0.5 * (1 / std::sqrt(1 - ct) + 1));  // kL
  const Anchor at = measured(anchor, ct, turbulence_intensity, hub_height_m / diameter_m);
  const double widening = std::max(1.001, 2 * at.radius / rotor_ratio);
  origin_m_ = at.distance * diameter_m / (widening * widening * widening - 1);
  const double c1 = std::pow(0.5 * rotor_ratio * diameter_m, 2.5) *
                    std::sqrt(2 * constants::pi / 105) *
                    std::pow(thrust_area_m2 * origin_m_, -5.0 / 6.0);
  edge_scale_ = std::pow(105 * c1 * c1 / (2 * constants::pi), 0.2) * std::cbrt(thrust_area_m2);
  // On the axis the braces are (35/2pi)^0.6 (3 c1^2)^-0.4, and they close at R_w, so that the whole
  // is the axis value times [1 - (r/R_w)^1.5]^2.
  axis_scale_ = std::cbrt(thrust_area_m2) / 9 * std::pow(35 / (2 * constants::pi), 0.6) *
                std::pow(3 * c1 * c1, -0.4);
  const double touch_m = at.distance * diameter_m;
  tangent_slope_ = edge_m(touch_m) / (3 * (touch_m + origin_m_));
  tangent_m_ = edge_m(touch_m) - tangent_slope_ * touch_m;
}

double LarsenWake::edge_m(double downstream_m) const noexcept {
  return edge_scale_ * std::cbrt(downstream_m + origin_m_);
}

double LarsenWake::deficit(double downstream_m, double radius_m) const noexcept {
  const double root = std::cbrt(downstream_m + origin_m_);
  const double ratio = radius_m / (edge_scale_ * root);
  if (ratio >= 1) return 0;
  const double inside = 1 - ratio * std::sqrt(ratio);
  return axis_scale_ / (root * root) * inside * inside;
}

}  // namespace slackwater
