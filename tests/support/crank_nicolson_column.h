#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "fields/base/frame.h"

namespace slackwater {

/// An oracle that shares no line with the model: the column of constant viscosity integrated on a
/// grid.
///
///   W_t + i f W = P(t) + (nu W_z)_z,   nu W_z = tau/rho at the surface,   nu W_z = r W at the base
///
/// Finite volumes over depth, Crank-Nicolson in time: second order in both. Starts at rest.
class CrankNicolsonColumn {
 public:
  CrankNicolsonColumn(double depth_m, std::size_t cells, double viscosity_m2_s, double friction_m_s,
                      double coriolis_rad_s, double step_s)
      : cell_m_(depth_m / static_cast<double>(cells)), step_s_(step_s), w_(cells), right_(cells) {
    exchange_1_s_ = viscosity_m2_s / (cell_m_ * cell_m_);
    // The drag acts on the base, half a cell of viscosity below the last centre.
    const double drag_1_s = 1.0 / (1.0 / friction_m_s + 0.5 * cell_m_ / viscosity_m2_s) / cell_m_;
    const double off = -0.5 * step_s * exchange_1_s_;
    for (std::size_t j = 0; j < cells; ++j) {
      const double neighbours = (j > 0 ? 1.0 : 0.0) + (j + 1 < cells ? 1.0 : 0.0);
      diagonal_.emplace_back(-exchange_1_s_ * neighbours - (j + 1 == cells ? drag_1_s : 0.0),
                             -coriolis_rad_s);
      const Horizontal above = j > 0 ? off * upper_.back() : Horizontal{};
      pivot_.push_back(1.0 - 0.5 * step_s * diagonal_.back() - above);
      upper_.push_back(off / pivot_.back());
    }
  }

  /// One step; stress over density (m2/s2) and acceleration (m/s2) are those of its middle.
  void step(Horizontal stress_m2_s2, Horizontal acceleration_m_s2) {
    const std::size_t n = w_.size();
    const double off = -0.5 * step_s_ * exchange_1_s_;
    for (std::size_t j = 0; j < n; ++j) {
      Horizontal tendency = diagonal_[j] * w_[j];
      if (j > 0) tendency += exchange_1_s_ * w_[j - 1];
      if (j + 1 < n) tendency += exchange_1_s_ * w_[j + 1];
      right_[j] = w_[j] + 0.5 * step_s_ * tendency + step_s_ * acceleration_m_s2;
    }
    right_[0] += step_s_ * stress_m2_s2 / cell_m_;
    for (std::size_t j = 0; j < n; ++j) {
      if (j > 0) right_[j] -= off * right_[j - 1];
      right_[j] /= pivot_[j];
    }
    w_[n - 1] = right_[n - 1];
    for (std::size_t j = n - 1; j-- > 0;) w_[j] = right_[j] - upper_[j] * w_[j + 1];
  }

  /// Linear between the centres of the cells, held beyond the outermost.
  [[nodiscard]] Horizontal at_depth(double depth_m) const {
    const double x = std::clamp(depth_m / cell_m_ - 0.5, 0.0, static_cast<double>(w_.size() - 1));
    const auto j = std::min(static_cast<std::size_t>(x), w_.size() - 2);
    const double share = x - static_cast<double>(j);
    return (1.0 - share) * w_[j] + share * w_[j + 1];
  }

 private:
  double cell_m_;
  double step_s_;
  double exchange_1_s_ = 0;
  std::vector<Horizontal> w_;
  std::vector<Horizontal> right_;
  std::vector<Horizontal> diagonal_, upper_, pivot_;
};

}  // namespace slackwater
