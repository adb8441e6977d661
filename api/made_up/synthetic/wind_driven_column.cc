#include "api/made_up/synthetic/wind_driven_column.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::api {
namespace {

constexpr Horizontal imaginary{0, 1};
constexpr double column_step_h = 1.0 / 6;
constexpr std::size_t fractions = 65;
constexpr int modes = 48;

/// Root of k tan(k) = biot in (n pi, n pi + pi/2), by bisection: it must not fail for any biot > 0.
double mode_wavenumber(int n, double biot) {
  double low = n * constants::pi;
  double high = low + constants::pi / 2;
  const double sign = n % 2 == 0 ? 1 : -1;  // of the cosine in that interval
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (low + high);
    const double excess = sign * (middle * std::sin(middle) - biot * std::cos(middle));
    (excess < 0 ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// Weights of the four-point Lagrange polynomial at `x` in [0, 1] between the second and the third
/// point.
std::array<double, 4> cubic_weights(double x) noexcept {
  return {-x * (x - 1) * (x - 2) / 6, (x + 1) * (x - 1) * (x - 2) / 2, -(x + 1) * x * (x - 2) / 2,
          (x + 1) * x * (x - 1) / 6};
}

struct Stencil {
  std::size_t first = 0;
  std::array<double, 4> weight{};
};

Stencil stencil_at(double position, std::size_t size) noexcept {
  const double last_first = static_cast<double>(size) - 4;
  const double first = std::clamp(std::floor(position) - 1, 0.0, last_first);
  return {static_cast<std::size_t>(first), cubic_weights(position - first - 1)};
}

/// One eigenmode: damping with rotation, and what a unit of kinematic stress feeds into it.
struct Mode {
  Horizontal rate_1_s;        ///< -(i f + A k^2)
  double excitation_1_m = 0;  ///< phi(0) / integral of phi^2
  Horizontal amplitude{};
  std::array<double, fractions> shape{};
};

}  // namespace

ColumnMixing ColumnPhysics::at_depth(double water_depth_m) const noexcept {
  const double ratio = water_depth_m / reference_depth_m;
  return {.eddy_viscosity_m2_s = reference.eddy_viscosity_m2_s * ratio * ratio,
          .bottom_friction_m_s = reference.bottom_friction_m_s * ratio};
}

Horizontal bottom_layer_factor(const ColumnPhysics& physics, double water_depth_m, double depth_m,
                               double sigma_rad_s) noexcept {
  const ColumnMixing mixing = physics.at_depth(water_depth_m);
  const Horizontal lambda =
      std::sqrt(imaginary * (physics.coriolis_rad_s + sigma_rad_s) / mixing.eddy_viscosity_m2_s);
  const Horizontal top = mixing.bottom_friction_m_s * std::cosh(lambda * depth_m);
  const Horizontal bottom = mixing.bottom_friction_m_s * std::cosh(lambda * water_depth_m) +
                            mixing.eddy_viscosity_m2_s * lambda * std::sinh(lambda * water_depth_m);
  return 1.0 - top / bottom;
}

WindDrivenColumn::WindDrivenColumn(const ColumnPhysics& physics, double first_h, double last_h,
                                   const std::function<Horizontal(double)>& stress)
    : first_h_(first_h),
      reference_depth_m_(physics.reference_depth_m),
      times_(static_cast<std::size_t>(std::ceil((last_h - first_h) / column_step_h)) + 1) {
  expects(last_h > first_h + 1, "a wind history lasts more than an hour");
  const double depth = physics.reference_depth_m;
  const double viscosity = physics.reference.eddy_viscosity_m2_s;
  const double friction = physics.reference.bottom_friction_m_s;

  std::vector<Mode> basis(modes);
  std::array<Horizontal, fractions> tail{};  // the instant response of the modes that are left out
  for (std::size_t k = 0; k < fractions; ++k) {
    const double above_bed = depth * (1 - static_cast<double>(k) / (fractions - 1));
    tail[k] = above_bed / viscosity + 1 / friction;
  }
  for (int n = 0; n < modes; ++n) {
    Mode& mode = basis[static_cast<std::size_t>(n)];
    const double kh = mode_wavenumber(n, friction * depth / viscosity);
    const double damping_1_s = viscosity * (kh / depth) * (kh / depth);
    mode.rate_1_s = -(imaginary * physics.coriolis_rad_s + damping_1_s);
    mode.excitation_1_m = 1 / (0.5 * depth * (1 + std::sin(2 * kh) / (2 * kh)));
    for (std::size_t k = 0; k < fractions; ++k) {
      mode.shape[k] = std::cos(kh * static_cast<double>(k) / (fractions - 1));
      tail[k] -= mode.shape[k] * mode.excitation_1_m / damping_1_s;
    }
  }

  const double step_s = column_step_h * 3600;
  table_.assign(times_ * fractions, Horizontal{});
  Horizontal before = stress(first_h);
  for (std::size_t t = 1; t < times_; ++t) {
    const Horizontal after = stress(first_h + static_cast<double>(t) * column_step_h);
    const Horizontal slope = (after - before) / step_s;
    Horizontal* row = &table_[t * fractions];
    for (std::size_t k = 0; k < fractions; ++k) row[k] = tail[k] * after;
    for (Mode& mode : basis) {
      // Exact over the step for stress that is linear in time.
      const Horizontal decay = std::exp(mode.rate_1_s * step_s);
      const Horizontal constant_part = (decay - 1.0) / mode.rate_1_s;
      const Horizontal slope_part = (constant_part - step_s) / mode.rate_1_s;
      mode.amplitude = decay * mode.amplitude +
                       mode.excitation_1_m * (constant_part * before + slope_part * slope);
      for (std::size_t k = 0; k < fractions; ++k) row[k] += mode.amplitude * mode.shape[k];
    }
    before = after;
  }
}

Horizontal WindDrivenColumn::velocity(double water_depth_m, double depth_m,
                                      double hours) const noexcept {
  const double fraction = std::clamp(depth_m / water_depth_m, 0.0, 1.0);
  const Stencil in_time = stencil_at((hours - first_h_) / column_step_h, times_);
  const Stencil in_depth = stencil_at(fraction * (fractions - 1), fractions);
  Horizontal sum = 0;
  for (std::size_t t = 0; t < 4; ++t) {
    const Horizontal* row = &table_[(in_time.first + t) * fractions + in_depth.first];
    Horizontal level = 0;
    for (std::size_t k = 0; k < 4; ++k) level += in_depth.weight[k] * row[k];
    sum += in_time.weight[t] * level;
  }
  return sum * (reference_depth_m_ / water_depth_m);
}

}  // namespace slackwater::api
