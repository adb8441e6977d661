#pragma once
#include <Eigen/Core>
#include <array>
#include <span>
#include <string>

#include "tests/published/profile_form.h"
#include "tests/published/profile_level.h"

namespace slackwater::calibration {

using ProfileEstimate = std::array<double, profile_parameter_count>;

struct ProfileMinimum {
  ProfileForm form = ProfileForm::free_scales;
  ProfileEstimate estimate{};
  double cost = 0;  ///< half the sum of squares, whitened: misfit and priors
  bool converged = false;
  std::string termination;  ///< one sentence
};

/// Residual of one level: (fitted - observed)/sigma, east then north; whitened by the standard
/// deviation that the caller states (`ProfileFitOptions`).
struct ProfileLevelResidual {
  ProfileForm form;
  ProfileLevel level;
  double sigma_m_s;
  bool is_northern;

  template <typename T>
  bool operator()(const T* estimate, T* residual) const {
    const Complex<T> w = profile_of(form, estimate, is_northern).at_depth(level.depth_m);
    residual[0] = (w.re - T(level.current_m_s.real())) / T(sigma_m_s);
    residual[1] = (w.im - T(level.current_m_s.imag())) / T(sigma_m_s);
    using std::isfinite;
    return isfinite(residual[0]) && isfinite(residual[1]);
  }
};

/// The minimum that one start leads to, within the bounds.
[[nodiscard]] ProfileMinimum minimise_profile(ProfileForm form, Angle latitude,
                                              std::span<const ProfileLevel> levels,
                                              double sigma_m_s, const ProfileEstimate& start);

using ProfileInformation = Eigen::Matrix<double, profile_parameter_count, profile_parameter_count>;

/// J'J of the levels at a point: what they say with this whitening, priors not counted.
[[nodiscard]] ProfileInformation profile_information(ProfileForm form, bool is_northern,
                                                     std::span<const ProfileLevel> levels,
                                                     double sigma_m_s,
                                                     const ProfileEstimate& estimate);

}  // namespace slackwater::calibration
