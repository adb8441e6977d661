#pragma once
#include <array>
#include <span>
#include <vector>

#include "tests/published/profile_form.h"
#include "tests/published/profile_level.h"

namespace slackwater::calibration {

/// A point from which the fit of a profile may start, in the order of `ProfileIndex`.
struct ProfileStart {
  std::array<double, profile_parameter_count> estimate{};
  double cost = 0;  ///< half the sum of squared residuals and priors, as in the fit
};

/// The starting points of one form, best first; at least one, at most `count`.
///
/// With its lengths held, the profile is linear in its vectors: a complex ridge problem solved
/// exactly. The lengths run over a fixed grid, a start is a depth of the base that is better than
/// its neighbours, and nothing is random: the same profile has the same starts on any machine.
///
/// @param sigma_m_s  whitening of each component, > 0
[[nodiscard]] std::vector<ProfileStart> profile_starts(ProfileForm form, Angle latitude,
                                                       std::span<const ProfileLevel> levels,
                                                       double sigma_m_s, std::size_t count);

}  // namespace slackwater::calibration
