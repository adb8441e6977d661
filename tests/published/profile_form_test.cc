#include "tests/published/profile_form.h"

#include <ceres/jet.h>
#include <gtest/gtest.h>

#include <set>

#include "calibration/solve/parameter_set.h"
#include "tests/published/synthetic_profile.h"

namespace slackwater::calibration::tests::profile_form_test {
namespace {

using Jet = ceres::Jet<double, profile_parameter_count>;

Horizontal value(ProfileForm form, const ProfileEstimate& x, bool is_northern, double depth_m) {
  return to_horizontal(profile_of(form, x.data(), is_northern).at_depth(depth_m));
}

TEST(ProfileForm, GradientAgreesWithFiniteDifferences) {
  // Central differences of step h err by h^2 f'''/6 and eps/h: 1e-7 of values near 1 for h 1e-5.
  constexpr double step = 1e-5;
  for (const ProfileForm form : profile_forms) {
    for (const bool is_northern : {true, false}) {
      const ProfileEstimate x = plain_truth(form);
      std::array<Jet, profile_parameter_count> jets;
      for (std::size_t i = 0; i < x.size(); ++i) jets[i] = Jet(x[i], static_cast<int>(i));
      for (const double depth_m : {0.0, 12.0, 48.0, 56.0, 140.0}) {
        const Complex<Jet> w = profile_of(form, jets.data(), is_northern).at_depth(depth_m);
        for (std::size_t i = 0; i < x.size(); ++i) {
          ProfileEstimate up = x;
          ProfileEstimate down = x;
          up[i] += step;
          down[i] -= step;
          const Horizontal slope =
              (value(form, up, is_northern, depth_m) - value(form, down, is_northern, depth_m)) /
              (2 * step);
          const auto k = static_cast<Eigen::Index>(i);
          EXPECT_NEAR(w.re.v(k), slope.real(), 1e-7) << i << " at " << depth_m;
          EXPECT_NEAR(w.im.v(k), slope.imag(), 1e-7) << i << " at " << depth_m;
        }
      }
    }
  }
}

TEST(ProfileForm, HasNineParametersWithPriorsInsideTheirBounds) {
  for (const ProfileForm form : profile_forms) {
    const auto parameters = profile_parameters(form, mid_latitude);
    EXPECT_EQ(parameters.size(), profile_parameter_count);
    std::set<std::string> names;
    for (const Parameter& p : parameters) {
      EXPECT_TRUE(names.insert(p.name).second) << p.name;
      EXPECT_GT(estimated(p, p.prior) - prior_of(p).sigma, estimated(p, p.lower)) << p.name;
      EXPECT_LT(estimated(p, p.prior) + prior_of(p).sigma, estimated(p, p.upper)) << p.name;
      EXPECT_FALSE(p.source.empty()) << p.name;
    }
  }
}

TEST(ProfileForm, ShearedInteriorTiesBothLengthsToTheDepthOfTheBase) {
  const ProfileEstimate x = plain_truth(ProfileForm::sheared_interior);
  const auto shape = shape_of(ProfileForm::sheared_interior, x.data(), true);
  EXPECT_DOUBLE_EQ(shape.base_half_thickness_m, typical_base_ratio * shape.base_depth_m);
  EXPECT_DOUBLE_EQ(shape.spiral_scale_m, typical_spiral_ratio * shape.base_depth_m);
}

}  // namespace
}  // namespace slackwater::calibration::tests::profile_form_test
