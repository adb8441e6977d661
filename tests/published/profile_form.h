#pragma once
#include <array>
#include <cmath>
#include <cstddef>
#include <string_view>
#include <vector>

#include "calibration/solve/calibration.h"
#include "tests/published/mixed_layer_profile.h"

namespace slackwater::calibration {

/// Which nine numbers of the mixed-layer profile are free. It has eleven (four vectors and three
/// lengths); a profile of a few dozen levels does not carry them all.
enum class ProfileForm {
  free_scales,       ///< no shear in the interior; thickness of the base and spiral scale are free
  sheared_interior,  ///< the interior has shear; both lengths are shares of the mixed layer's depth
};
inline constexpr std::array profile_forms{ProfileForm::free_scales, ProfileForm::sheared_interior};

/// The name of a form as it stands in reports: "free_scales", "sheared_interior".
[[nodiscard]] std::string_view name_of(ProfileForm form) noexcept;

inline constexpr std::size_t profile_parameter_count = 9;

/// w/h where it is not free, and the middle of its prior where it is: the step at the base takes a
/// third of the mixed layer's depth (2w = 0.3 h).
inline constexpr double typical_base_ratio = 0.15;
/// l/h where it is not free. A boundary layer with nu = kappa u* h (4/27), the largest value of the
/// cubic profile of Large, McWilliams and Doney (1994, Rev. Geophys. 32, 363-403), and h between
/// 0.4 and 0.7 u*/|f| has l/h = sqrt(2 nu/|f|)/h between 0.54 and 0.41.
inline constexpr double typical_spiral_ratio = 0.5;

/// The order of the nine; the last two depend on the form.
enum ProfileIndex : std::size_t {
  interior_at = 0,  ///< east, then north, and so on
  slab_at = 2,
  spiral_at = 4,
  log_base_depth_at = 6,
  log_base_ratio_at = 7,    ///< free_scales
  log_spiral_scale_at = 8,  ///< free_scales
  shear_at = 7,             ///< sheared_interior
};

/// The three lengths from the estimate.
template <typename T>
[[nodiscard]] MixedLayerShape<T> shape_of(ProfileForm form, const T* estimate, bool is_northern) {
  using std::exp;
  const T h = exp(estimate[log_base_depth_at]);
  if (form == ProfileForm::free_scales) {
    return {h, h * exp(estimate[log_base_ratio_at]), exp(estimate[log_spiral_scale_at]),
            is_northern};
  }
  return {h, h * T(typical_base_ratio), h * T(typical_spiral_ratio), is_northern};
}

/// The forward model from the estimate: nine numbers in the order of `ProfileIndex`.
template <typename T>
[[nodiscard]] MixedLayerProfile<T> profile_of(ProfileForm form, const T* estimate,
                                              bool is_northern) {
  const auto vector_at = [&](std::size_t i) { return Complex<T>{estimate[i], estimate[i + 1]}; };
  MixedLayerProfile<T> profile;
  profile.interior_m_s = vector_at(interior_at);
  profile.slab_m_s = vector_at(slab_at);
  profile.spiral_m_s = vector_at(spiral_at);
  profile.shear_per_s =
      form == ProfileForm::sheared_interior ? vector_at(shear_at) : Complex<T>{T(0.0), T(0.0)};
  profile.shape = shape_of(form, estimate, is_northern);
  return profile;
}

/// The nine with names, units, priors, bounds and sources. The prior of the spiral's scale is that
/// of the eddy viscosity of the daily calibration at this latitude
/// (calibration/solve/parameter_set.h).
[[nodiscard]] std::vector<Parameter> profile_parameters(ProfileForm form, Angle latitude);

}  // namespace slackwater::calibration
