#pragma once
#include <cmath>
#include <vector>

#include "tests/published/profile_form.h"
#include "tests/published/profile_level.h"
#include "tests/published/profile_problem.h"

namespace slackwater::calibration::tests {

inline const Angle mid_latitude = Angle::from_degrees(47.0);

/// A stretched grid of 24 levels from 0.5 to 150 m, like a product's.
inline std::vector<double> stretched_depths_m() {
  std::vector<double> depths_m;
  for (int i = 0; i < 24; ++i) depths_m.push_back(0.5 + 149.5 * std::pow(i / 23.0, 2.2));
  return depths_m;
}

/// What the forward model gives at these depths.
inline std::vector<ProfileLevel> levels_of(const MixedLayerProfile<double>& profile,
                                           const std::vector<double>& depths_m) {
  std::vector<ProfileLevel> levels;
  for (const double d : depths_m) levels.push_back({d, to_horizontal(profile.at_depth(d))});
  return levels;
}

/// A profile of each form in which every parameter shows.
inline ProfileEstimate plain_truth(ProfileForm form) {
  ProfileEstimate truth{0.10, -0.06, 0.18, 0.09, -0.07, 0.12, std::log(52.0), 0.0, 0.0};
  if (form == ProfileForm::free_scales) {
    truth[log_base_ratio_at] = std::log(0.1);
    truth[log_spiral_scale_at] = std::log(14.0);
  } else {
    truth[shear_at] = 6e-4;
    truth[shear_at + 1] = -4e-4;
  }
  return truth;
}

inline std::vector<ProfileLevel> plain_levels(ProfileForm form, bool is_northern = true) {
  return levels_of(profile_of(form, plain_truth(form).data(), is_northern), stretched_depths_m());
}

}  // namespace slackwater::calibration::tests
