#include "tests/published/published_profiles.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "fields/base/numbers/statistics.h"
#include "tests/published/held_out.h"
#include "tests/support/shared_data.h"

// The published benchmark (calibration/docs/published_evaluation.md): same-day fit of the 0-150 m
// profile, unweighted over native levels. Documented command, prints the table:
//
//   build/release/tests/slackwater_published_tests --gtest_filter='PublishedProfiles.*'

namespace slackwater::tests::published_profiles_test {
namespace {

using calibration::ProfileForm;
using calibration::ProfileLevel;

constexpr double deepest_m = 150.0;
const Angle box_latitude = Angle::from_degrees(46.8);  // middle of 46.6 to 47.0 N

struct DateScore {
  std::string date;
  ProfileForm form = ProfileForm::free_scales;
  double eps_m_s = 0;
  double eps_constant_m_s = 0;
  double held_out_gain = 0;
  double fit_ms = 0;
  int parameters = 0;
  int warnings = 0;
};

DateScore score(const PublishedProfile& profile, std::optional<ProfileForm> form, Angle latitude) {
  const calibration::ProfileFitOptions options{.form = form};
  const auto begin = std::chrono::steady_clock::now();
  const auto fit = calibration::fit_profile(profile.levels, latitude, options);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - begin;
  const auto held_out = calibration::score_held_out_levels(profile.levels, latitude, options);
  return {profile.date,
          fit.form,
          fit.eps_m_s,
          fit.eps_constant_m_s,
          held_out.gain(),
          spent.count(),
          static_cast<int>(fit.parameters.size()),
          static_cast<int>(fit.warnings.size())};
}

template <typename Member>
double median_over(const std::vector<DateScore>& scores, Member member) {
  std::vector<double> values;
  for (const DateScore& s : scores) values.push_back(s.*member);
  return median(values);
}

double median_eps(const std::map<std::string, PublishedAccuracy>& theirs) {
  std::vector<double> values;
  for (const auto& [date, accuracy] : theirs) values.push_back(accuracy.eps_m_s);
  return median(values);
}

void print_row(const DateScore& s, const std::map<std::string, PublishedAccuracy>& theirs) {
  const auto their = theirs.find(s.date);
  if (their == theirs.end()) {
    std::printf("%-10s %8s %7s", s.date.c_str(), "-", "-");
  } else {
    std::printf("%-10s %8.4f %6.0f%%", s.date.c_str(), their->second.eps_m_s,
                their->second.reduction_percent);
  }
  std::printf(" | %8.4f %6.1f%% %8.1f%%  %-16s %d  %5.1f  %d\n", s.eps_m_s,
              100 * (1 - s.eps_m_s / s.eps_constant_m_s), 100 * s.held_out_gain,
              std::string(name_of(s.form)).c_str(), s.parameters, s.fit_ms, s.warnings);
}

void print_table(const std::vector<DateScore>& scores,
                 const std::map<std::string, PublishedAccuracy>& theirs) {
  std::printf("           published fit    | ours\n");
  std::printf("%-10s %8s %7s | %8s %7s %9s  %-16s %s\n", "date", "eps m/s", "gain", "eps m/s",
              "gain", "held out", "form", "n   ms   warnings");
  std::vector<double> their_eps;
  std::vector<double> their_gain;
  for (const DateScore& s : scores) {
    print_row(s, theirs);
    if (const auto their = theirs.find(s.date); their != theirs.end()) {
      their_eps.push_back(their->second.eps_m_s);
      their_gain.push_back(1 - their->second.eps_m_s / their->second.eps_constant_m_s);
    }
  }
  if (!their_eps.empty()) {
    std::printf("medians over %zu dates: theirs eps %.4f m/s, gain %.1f %%\n", their_eps.size(),
                median(their_eps), 100 * median(their_gain));
  }
  std::printf("medians over %zu dates: ours eps %.4f m/s, gain on held-out levels %.1f %%\n",
              scores.size(), median_over(scores, &DateScore::eps_m_s),
              100 * median_over(scores, &DateScore::held_out_gain));
}

std::vector<DateScore> scores_of(const std::vector<PublishedProfile>& profiles,
                                 std::optional<ProfileForm> form, Angle latitude) {
  std::vector<DateScore> scores;
  for (const PublishedProfile& profile : profiles) scores.push_back(score(profile, form, latitude));
  return scores;
}

/// Skips, with a message, where the data are absent.
#define SLACKWATER_NEEDS_PUBLISHED_PROFILES(folder)               \
  SLACKWATER_NEEDS_SHARED(shared);                                \
  const std::filesystem::path folder = shared / "data" / "brest"; \
  if (!std::filesystem::exists(folder / "profiles"))              \
  GTEST_SKIP() << "no published profiles: expected " << (folder / "profiles").string()

TEST(PublishedProfiles, AreFittedWithNineParametersAndPredictedOnHeldOutLevels) {
  SLACKWATER_NEEDS_PUBLISHED_PROFILES(folder);
  const auto profiles = published_profiles(folder / "profiles", deepest_m);
  ASSERT_FALSE(profiles.empty());
  const auto scores = scores_of(profiles, std::nullopt, box_latitude);
  print_table(scores, published_accuracy(folder / "published_field_accuracy.csv"));
  for (const DateScore& s : scores) EXPECT_LE(s.parameters, 9) << s.date;
  EXPECT_LE(median_over(scores, &DateScore::eps_m_s), 0.0085);
  EXPECT_GE(median_over(scores, &DateScore::held_out_gain), 0.70);
}

TEST(PublishedProfiles, AreMeasuredWithThePublishedRuler) {
  SLACKWATER_NEEDS_PUBLISHED_PROFILES(folder);
  const auto theirs = published_accuracy(folder / "published_field_accuracy.csv");
  int compared = 0;
  for (const PublishedProfile& profile : published_profiles(folder / "profiles", deepest_m)) {
    const auto their = theirs.find(profile.date);
    if (their == theirs.end()) continue;
    const auto fit = calibration::fit_profile(profile.levels, box_latitude);
    // Half their last digit, and the six decimals of the profiles.
    EXPECT_NEAR(fit.eps_constant_m_s, their->second.eps_constant_m_s, 0.6e-4) << profile.date;
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

TEST(PublishedProfiles, EitherFormAloneHalvesThePublishedError) {
  SLACKWATER_NEEDS_PUBLISHED_PROFILES(folder);
  const auto profiles = published_profiles(folder / "profiles", deepest_m);
  const auto theirs = published_accuracy(folder / "published_field_accuracy.csv");
  ASSERT_FALSE(profiles.empty());
  for (const ProfileForm form : calibration::profile_forms) {
    const auto scores = scores_of(profiles, form, box_latitude);
    std::printf("%-16s alone: eps %.4f m/s, gain on held-out levels %.1f %%\n",
                std::string(name_of(form)).c_str(), median_over(scores, &DateScore::eps_m_s),
                100 * median_over(scores, &DateScore::held_out_gain));
    EXPECT_LT(median_over(scores, &DateScore::eps_m_s), 0.5 * median_eps(theirs));
  }
}

TEST(PublishedProfiles, TurnWithDepthAsTheNorthernHemisphereDoes) {
  // The published form turns with the sense of the south. Nothing but the sign of f is changed
  // here.
  SLACKWATER_NEEDS_PUBLISHED_PROFILES(folder);
  const auto profiles = published_profiles(folder / "profiles", deepest_m);
  ASSERT_FALSE(profiles.empty());
  const auto north = scores_of(profiles, std::nullopt, box_latitude);
  const auto south = scores_of(profiles, std::nullopt, -box_latitude);
  double log_ratio = 0;
  for (std::size_t i = 0; i < north.size(); ++i)
    log_ratio += std::log(north[i].eps_m_s / south[i].eps_m_s);
  std::printf(
      "northern sense: eps %.4f m/s, held out %.1f %%; southern: %.4f m/s, %.1f %%\n",
      median_over(north, &DateScore::eps_m_s), 100 * median_over(north, &DateScore::held_out_gain),
      median_over(south, &DateScore::eps_m_s), 100 * median_over(south, &DateScore::held_out_gain));
  EXPECT_LT(log_ratio, 0);  // geometric mean over dates: 0.81 on the 26 dates first seen
}

}  // namespace
}  // namespace slackwater::tests::published_profiles_test
