// The fitted profile beside what joins the dots: on every other level, where a line between two
// neighbours is hard to beat, and on stretches of levels left out, where dots say nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "fields/base/numbers/statistics.h"
#include "tests/published/held_out.h"
#include "tests/published/joined_dots.h"
#include "tests/published/published_profiles.h"
#include "tests/support/shared_data.h"

namespace slackwater::tests::profile_rivals_test {
namespace {

using calibration::ProfileLevel;

constexpr double deepest_m = 150.0;
const Angle box_latitude = Angle::from_degrees(46.8);

double error_of(Joined how, const std::vector<ProfileLevel>& levels,
                const std::vector<bool>& trains) {
  std::vector<ProfileLevel> training;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (trains[i]) training.push_back(levels[i]);
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < levels.size(); ++i) {
    if (trains[i]) continue;
    sum += std::norm(levels[i].current_m_s - joined_at(training, how, levels[i].depth_m));
    ++count;
  }
  return std::sqrt(sum / count);
}

/// Median over dates of the error on held-out levels.
struct Row {
  double fitted = 0;
  double constant = 0;
  std::map<Joined, double> joined;
};

Row row_of(const char* what, const std::vector<PublishedProfile>& profiles,
           const std::function<std::vector<std::vector<bool>>(const PublishedProfile&)>& splits) {
  std::vector<double> fitted;
  std::vector<double> constant;
  std::map<Joined, std::vector<double>> joined;
  for (const PublishedProfile& profile : profiles) {
    double square = 0;
    double square_constant = 0;
    std::map<Joined, double> squares;
    const auto all = splits(profile);
    if (all.empty()) continue;
    const auto count = static_cast<double>(all.size());
    for (const std::vector<bool>& trains : all) {
      const auto score = calibration::score_held_out(profile.levels, trains, box_latitude);
      square += score.eps_m_s * score.eps_m_s / count;
      square_constant += score.eps_constant_m_s * score.eps_constant_m_s / count;
      for (const Joined how : all_joined)
        squares[how] += std::pow(error_of(how, profile.levels, trains), 2) / count;
    }
    fitted.push_back(std::sqrt(square));
    constant.push_back(std::sqrt(square_constant));
    for (const Joined how : all_joined) joined[how].push_back(std::sqrt(squares[how]));
  }
  Row row{median(fitted), median(constant), {}};
  std::printf("%-22s fitted %.4f  constant %.4f", what, row.fitted, row.constant);
  for (const Joined how : all_joined) {
    row.joined[how] = median(joined[how]);
    std::printf("  %s %.4f", std::string(name_of(how)).c_str(), row.joined[how]);
  }
  std::printf(" m/s, median of %zu dates\n", fitted.size());
  return row;
}

TEST(JoinedDots, AreExactWhereTheirFamilyHoldsTheTruth) {
  std::vector<ProfileLevel> line;
  for (const double depth : {0.0, 3.0, 10.0, 24.0})
    line.push_back({depth, {0.1 - 0.002 * depth, 0.05 + 0.004 * depth}});
  for (const Joined how : all_joined) {
    EXPECT_LT(std::abs(joined_at(line, how, 6) - Horizontal(0.088, 0.074)), 1e-12) << name_of(how);
    EXPECT_EQ(joined_at(line, how, 40), line.back().current_m_s) << "held beyond the last";
    for (const ProfileLevel& level : line)
      EXPECT_LT(std::abs(joined_at(line, how, level.depth_m) - level.current_m_s), 1e-12);
  }
  // Monotone data: PCHIP does not overshoot a step, a spline does.
  std::vector<ProfileLevel> step;
  for (int i = 0; i < 8; ++i) step.push_back({double(i), {i < 4 ? 0.0 : 1.0, 0.0}});
  double spline_most = 0;
  for (double z = 0; z <= 7; z += 0.05) {
    EXPECT_LE(joined_at(step, Joined::pchip, z).real(), 1.0 + 1e-12);
    spline_most = std::max(spline_most, joined_at(step, Joined::spline, z).real());
  }
  EXPECT_GT(spline_most, 1.02);
}

TEST(PublishedProfiles, AgainstWhatJoinsTheDots) {
  SLACKWATER_NEEDS_SHARED(shared);
  const std::filesystem::path folder = shared / "data" / "brest";
  if (!std::filesystem::exists(folder / "profiles"))
    GTEST_SKIP() << "no published profiles: expected " << (folder / "profiles").string();
  const auto profiles = published_profiles(folder / "profiles", deepest_m);
  ASSERT_FALSE(profiles.empty());
  const auto third = [](std::size_t band) {
    return [band](const PublishedProfile& profile) {
      const auto bands = calibration::held_out_bands(profile.levels);
      return band < bands.size() ? std::vector<std::vector<bool>>{bands[band]}
                                 : std::vector<std::vector<bool>>{};
    };
  };
  const Row other = row_of("every other level", profiles, [](const PublishedProfile& profile) {
    return std::vector<std::vector<bool>>{calibration::training_levels(profile.levels.size(), 0),
                                          calibration::training_levels(profile.levels.size(), 1)};
  });
  const Row upper = row_of("the upper third", profiles, third(0));
  const Row middle = row_of("the middle third", profiles, third(1));
  const Row lower = row_of("the lower third", profiles, third(2));
  const Row deep = row_of("everything below 60 m", profiles, third(3));
  EXPECT_LT(other.fitted, 0.5 * other.constant);
  // Towards the surface the profile knows how a mixed layer turns, and dots do not.
  for (const Joined how : all_joined) EXPECT_LT(upper.fitted, upper.joined.at(how)) << name_of(how);
  // Between levels the dots win, and below the last level nobody knows: api/docs/skill.md says so.
  EXPECT_LT(middle.fitted, 0.5 * middle.constant);
  EXPECT_LT(lower.fitted, lower.constant);
  EXPECT_LT(deep.fitted, 1.2 * deep.constant);
}

}  // namespace
}  // namespace slackwater::tests::profile_rivals_test
