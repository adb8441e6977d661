#pragma once
#include <cstddef>

#include "fields/current/steady_column.h"

namespace slackwater::calibration {

/// Which quantities a day estimates, and where each stands in every vector of this room:
///
///   interior (2) | ln viscosity, ln bottom | ln stress factor | ln mixed layer | trend (2)
///   | inertial (2)
///
/// two numbers of a vector are its east and north components. What a day does not estimate takes no
/// place.
struct ParameterLayout {
  SteadyForm form = SteadyForm::finite_depth;
  bool has_shape = true;     ///< not in the equatorial band
  bool has_wind = true;      ///< the wind-driven term is fitted
  bool is_unsteady = false;  ///< trend of the interior and free inertial motion are fitted too

  static constexpr std::size_t interior = 0;
  static constexpr std::size_t log_viscosity = 2;  ///< with has_shape
  static constexpr std::size_t log_bottom = 3;     ///< with has_shape
  [[nodiscard]] bool has_layer() const noexcept {
    return has_shape && form == SteadyForm::mixed_layer;
  }
  [[nodiscard]] bool has_modes() const noexcept {
    return is_unsteady && has_shape && form != SteadyForm::three_layer;
  }
  [[nodiscard]] std::size_t log_factor() const noexcept { return has_shape ? 4 : 2; }
  [[nodiscard]] std::size_t log_layer() const noexcept { return log_factor() + (has_wind ? 1 : 0); }
  [[nodiscard]] std::size_t trend() const noexcept { return log_layer() + (has_layer() ? 1 : 0); }
  [[nodiscard]] std::size_t inertial() const noexcept { return trend() + (is_unsteady ? 2 : 0); }
  [[nodiscard]] std::size_t count() const noexcept { return inertial() + (has_modes() ? 2 : 0); }
};

}  // namespace slackwater::calibration
