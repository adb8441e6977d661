#include "calibration/propagate/transient_column.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/current/coriolis.h"

namespace slackwater::calibration {
namespace {

constexpr int most_modes = 64;
constexpr double instant_per_h = 12.0;

}  // namespace

double column_mode_wavenumber_1_m(int n, double eddy_viscosity_m2_s, double bottom_friction_m_s,
                                  double water_depth_m) {
  const double biot = bottom_friction_m_s * water_depth_m / eddy_viscosity_m2_s;
  double low = n * constants::pi;
  double high = low + 0.5 * constants::pi;
  const double sign = n % 2 == 0 ? 1 : -1;  // of the cosine between them
  // Bisection: x tan(x) - biot, times cos(x), has one sign change here for any biot > 0.
  for (int i = 0; i < 60; ++i) {
    const double x = 0.5 * (low + high);
    (sign * (x * std::sin(x) - biot * std::cos(x)) < 0 ? low : high) = x;
  }
  return 0.5 * (low + high) / water_depth_m;
}

TransientColumn::TransientColumn(const Calibration& calibration, const LevelResponses& responses,
                                 const HourlyStress& stress, double deep_damping_per_h)
    : levels_(responses.levels()) {
  if (!calibration.wind_used || is_equatorial(calibration.latitude)) return;
  const double coriolis_rad_s = coriolis_parameter_rad_s(calibration.latitude);
  if (calibration.form == SteadyForm::three_layer) {
    memory_.emplace_back(stress, Horizontal(deep_damping_per_h, 3600.0 * coriolis_rad_s));
    for (std::size_t k = 0; k < levels_; ++k) response_.push_back(responses.stress(k));
    return;
  }
  const SteadyParameters p = steady_parameters(calibration);
  const double depth_m = calibration.water_depth_m;
  for (int n = 0; n < most_modes; ++n) {
    const double k_1_m =
        column_mode_wavenumber_1_m(n, p.eddy_viscosity_m2_s, p.bottom_friction_m_s, depth_m);
    const Horizontal lambda_1_s(p.eddy_viscosity_m2_s * k_1_m * k_1_m, coriolis_rad_s);
    if (n > 0 && 3600.0 * lambda_1_s.real() > instant_per_h) break;
    const double kh = k_1_m * depth_m;
    const double norm_m = 0.5 * depth_m * (1.0 + std::sin(2.0 * kh) / (2.0 * kh));
    const Horizontal scale =
        p.stress_factor / (constants::sea_water_density_kg_m3 * norm_m * lambda_1_s);
    memory_.emplace_back(stress, 3600.0 * lambda_1_s);
    for (const double d : responses.depth_m)
      response_.push_back(scale * std::cos(k_1_m * std::min(d, depth_m)));
  }
}

Horizontal TransientColumn::velocity(std::size_t k, const TimeCell& cell) const {
  expects(k < levels_, "a depth of the column");
  Horizontal sum{};
  for (std::size_t n = 0; n < memory_.size(); ++n)
    sum -= response_[n * levels_ + k] * memory_[n].over(cell);
  return sum;
}

void TransientColumn::velocities(const TimeCell& cell, std::span<Horizontal> out) const {
  expects(out.size() == levels_, "one value per depth");
  std::fill(out.begin(), out.end(), Horizontal{});
  for (std::size_t n = 0; n < memory_.size(); ++n) {
    const Horizontal memory = memory_[n].over(cell);
    for (std::size_t k = 0; k < levels_; ++k) out[k] -= response_[n * levels_ + k] * memory;
  }
}

}  // namespace slackwater::calibration
