#include "tests/published/fit_profile.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/published/synthetic_profile.h"
#include "tests/support/asked_number.h"

namespace slackwater::calibration::tests::fit_profile_test {
namespace {

// So small that the priors weigh nothing.
constexpr ProfileFitOptions exact_data{.form = std::nullopt, .sigma_m_s = 1e-5};

TEST(FitProfile, RecoversAnExactProfileAndTheFormItCameFrom) {
  for (const ProfileForm form : profile_forms) {
    const ProfileEstimate truth = plain_truth(form);
    const FittedProfile fit = fit_profile(plain_levels(form), mid_latitude, exact_data);
    EXPECT_EQ(fit.form, form);
    EXPECT_LT(fit.eps_m_s, 1e-6);
    ASSERT_EQ(fit.parameters.size(), profile_parameter_count);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const Parameter& p = fit.parameters[i];
      const double expected = p.is_logarithmic ? std::exp(truth[i]) : truth[i];
      EXPECT_NEAR(p.value, expected, 1e-3 * std::abs(expected)) << p.name;
    }
    EXPECT_TRUE(fit.warnings.empty()) << fit.warnings.front();
  }
}

TEST(FitProfile, BothFormsAreReportedAndTheCheaperOneIsTaken) {
  const FittedProfile fit = fit_profile(plain_levels(ProfileForm::sheared_interior), mid_latitude);
  ASSERT_EQ(fit.considered.size(), 2U);
  EXPECT_EQ(fit.considered[0].form, ProfileForm::free_scales);
  EXPECT_LT(fit.considered[1].cost, fit.considered[0].cost);
  EXPECT_EQ(fit.eps_m_s, fit.considered[1].eps_m_s);
}

TEST(FitProfile, AFormThatIsAskedForIsTheOnlyOneTried) {
  const ProfileFitOptions options{.form = ProfileForm::free_scales};
  const auto fit = fit_profile(plain_levels(ProfileForm::sheared_interior), mid_latitude, options);
  EXPECT_EQ(fit.form, ProfileForm::free_scales);
  EXPECT_EQ(fit.considered.size(), 1U);
}

TEST(FitProfile, TurningTheCurrentsTurnsTheFit) {
  const Horizontal turn = std::polar(1.0, 0.7);
  for (const ProfileForm form : profile_forms) {
    const auto levels = plain_levels(form);
    auto turned = levels;
    for (ProfileLevel& level : turned) level.current_m_s *= turn;
    const FittedProfile fit = fit_profile(levels, mid_latitude);
    const FittedProfile fit_turned = fit_profile(turned, mid_latitude);
    EXPECT_EQ(fit.form, fit_turned.form);
    for (const ProfileLevel& level : levels) {
      // The solver stops within 1e-9 of the cost: a thousandth of sigma, 1e-5 m/s.
      EXPECT_NEAR(std::abs(to_horizontal(fit_turned.profile.at_depth(level.depth_m)) -
                           to_horizontal(fit.profile.at_depth(level.depth_m)) * turn),
                  0, 1e-5);
    }
  }
}

TEST(FitProfile, MirrorsInTheSouthernHemisphere) {
  for (const ProfileForm form : profile_forms) {
    const auto levels = plain_levels(form);
    auto mirrored = levels;
    for (ProfileLevel& level : mirrored) level.current_m_s = std::conj(level.current_m_s);
    const FittedProfile north = fit_profile(levels, mid_latitude);
    const FittedProfile south = fit_profile(mirrored, -mid_latitude);
    for (const ProfileLevel& level : levels) {
      EXPECT_NEAR(std::abs(to_horizontal(south.profile.at_depth(level.depth_m)) -
                           std::conj(to_horizontal(north.profile.at_depth(level.depth_m)))),
                  0, 1e-5);
    }
  }
}

TEST(FitProfile, TheWrongSenseOfTurningFitsWorse) {
  for (const ProfileForm form : profile_forms) {
    const auto levels = plain_levels(form);
    EXPECT_GT(fit_profile(levels, -mid_latitude).eps_m_s,
              2 * fit_profile(levels, mid_latitude).eps_m_s);
  }
}

TEST(FitProfile, IsTheSameToTheBitWhenRunAgain) {
  const auto levels = plain_levels(ProfileForm::free_scales);
  const FittedProfile first = fit_profile(levels, mid_latitude);
  const FittedProfile second = fit_profile(levels, mid_latitude);
  EXPECT_EQ(first.covariance, second.covariance);
  EXPECT_EQ(first.eps_m_s, second.eps_m_s);
  for (std::size_t i = 0; i < profile_parameter_count; ++i)
    EXPECT_EQ(first.parameters[i].value, second.parameters[i].value);
}

TEST(FitProfile, TheOrderOfLevelsDoesNotMatter) {
  const auto levels = plain_levels(ProfileForm::free_scales);
  const std::vector<ProfileLevel> reversed(levels.rbegin(), levels.rend());
  EXPECT_NEAR(fit_profile(levels, mid_latitude).eps_m_s,
              fit_profile(reversed, mid_latitude).eps_m_s, 1e-6);
}

TEST(FitProfile, NinetyFivePercentIntervalsCoverTheTruthOfNoisyTwins) {
  const int twins = slackwater::tests::asked_number("SLACKWATER_TWINS", 60);
  constexpr double noise_m_s = 0.01;
  for (const ProfileForm form : profile_forms) {
    const ProfileEstimate truth = plain_truth(form);
    const ProfileFitOptions options{.form = form, .sigma_m_s = noise_m_s};
    Rng rng(20240607, "tests/profile_twins");
    int covered = 0;
    for (int twin = 0; twin < twins; ++twin) {
      auto levels = plain_levels(form);
      for (ProfileLevel& level : levels)
        level.current_m_s += noise_m_s * Horizontal(rng.normal(), rng.normal());
      const FittedProfile fit = fit_profile(levels, mid_latitude, options);
      for (std::size_t i = 0; i < profile_parameter_count; ++i) {
        const Parameter& p = fit.parameters[i];
        const double estimate = p.is_logarithmic ? std::log(p.value) : p.value;
        covered += std::abs(estimate - truth[i]) <= 1.96 * p.sigma ? 1 : 0;
      }
    }
    const double share = covered / (twins * static_cast<double>(profile_parameter_count));
    std::printf("%s: 95 %% intervals cover %.1f %%\n", std::string(name_of(form)).c_str(),
                100 * share);
    // Parameters of one twin are not independent: three standard errors of 200 draws, and a fit
    // that is not linear.
    EXPECT_GT(share, 0.90);
    EXPECT_LT(share, 0.995);
  }
}

TEST(FitProfile, ABoundThatIsReachedIsFlaggedAndWarnedOf) {
  ProfileEstimate truth = plain_truth(ProfileForm::free_scales);
  truth[log_base_ratio_at] = std::log(0.005);  // far sharper than the bound of 0.03
  std::vector<double> depths_m;
  for (int i = 0; i <= 200; ++i) depths_m.push_back(0.5 * i);
  const auto levels = levels_of(profile_of(ProfileForm::free_scales, truth.data(), true), depths_m);
  const ProfileFitOptions options{.form = ProfileForm::free_scales, .sigma_m_s = 1e-4};
  const FittedProfile fit = fit_profile(levels, mid_latitude, options);
  EXPECT_TRUE(fit.parameters[log_base_ratio_at].at_bound);
  ASSERT_FALSE(fit.warnings.empty());
  EXPECT_NE(fit.warnings.front().find("base_ratio"), std::string::npos) << fit.warnings.front();
}

TEST(FitProfile, AUniformCurrentSaysLittleOfTheMixedLayer) {
  std::vector<ProfileLevel> levels;
  for (const double d : stretched_depths_m()) levels.push_back({d, {0.2, -0.1}});
  const FittedProfile fit = fit_profile(levels, mid_latitude);
  EXPECT_TRUE(fit.parameters[log_base_depth_at].weakly_determined);
  ASSERT_FALSE(fit.warnings.empty());
  // The priors pull the three vectors apart, but their sum is what was seen.
  EXPECT_LT(fit.eps_m_s, 1e-3);
}

void expect_refusal(const std::vector<ProfileLevel>& levels, Angle latitude,
                    const ProfileFitOptions& options, const char* says) {
  try {
    static_cast<void>(fit_profile(levels, latitude, options));
    FAIL() << "accepted; expected a refusal that says: " << says;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find(says), std::string::npos) << error.message();
  }
}

TEST(FitProfile, RefusesWhatItCannotFitAndSaysWhy) {
  const auto levels = plain_levels(ProfileForm::free_scales);
  expect_refusal({levels.begin(), levels.begin() + 4}, mid_latitude, {}, "profile has 4 levels");
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto holed = levels;
    holed[3].current_m_s = {0.1, bad};
    expect_refusal(holed, mid_latitude, {}, "finite values");
    holed = levels;
    holed[3].depth_m = bad;
    expect_refusal(holed, mid_latitude, {}, "finite values");
  }
  auto above = levels;
  above[0].depth_m = -1;
  expect_refusal(above, mid_latitude, {}, "depth >= 0");
  auto twice = levels;
  twice[5].depth_m = twice[4].depth_m;
  expect_refusal(twice, mid_latitude, {}, "each depth once");
  expect_refusal(levels, Angle::from_degrees(1.0), {}, "nearer than 3 degrees");
  expect_refusal(levels, mid_latitude, {.form = std::nullopt, .sigma_m_s = 0}, "must be positive");
}

}  // namespace
}  // namespace slackwater::calibration::tests::fit_profile_test
