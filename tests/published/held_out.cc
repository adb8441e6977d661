#include "tests/published/held_out.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::calibration {
namespace {

constexpr std::size_t fewest_held_against = 9;
/// Below it a profile is held out as a whole.
constexpr double deep_m = 60.0;

struct Split {
  std::vector<ProfileLevel> training, held_out;
  Horizontal training_mean;
};

Split split(std::span<const ProfileLevel> levels, const std::vector<bool>& trains) {
  Split parts;
  for (std::size_t i = 0; i < levels.size(); ++i)
    (trains[i] ? parts.training : parts.held_out).push_back(levels[i]);
  for (const ProfileLevel& level : parts.training) parts.training_mean += level.current_m_s;
  parts.training_mean /= static_cast<double>(parts.training.size());
  return parts;
}

void check(std::span<const ProfileLevel> levels) {
  if (levels.size() < fewest_held_against) {
    throw Error(ErrorKind::invalid_input,
                "profile has " + std::to_string(levels.size()) + " levels: expected at least " +
                    std::to_string(fewest_held_against) + " so that five train in each parity");
  }
  if (!std::is_sorted(
          levels.begin(), levels.end(),
          [](const ProfileLevel& a, const ProfileLevel& b) { return a.depth_m < b.depth_m; })) {
    throw Error(ErrorKind::invalid_input,
                "levels of a profile are not in order: expected increasing depth; sort them");
  }
}

}  // namespace

std::vector<bool> training_levels(std::size_t n, int parity) {
  expects(parity == 0 || parity == 1, "parity of held-out levels is 0 or 1");
  std::vector<bool> trains(n);
  for (std::size_t i = 0; i < n; ++i)
    trains[i] = i % 2 == static_cast<std::size_t>(parity) || i == 0 || i + 1 == n;
  return trains;
}

std::vector<std::vector<bool>> held_out_bands(std::span<const ProfileLevel> levels) {
  const std::size_t n = levels.size();
  std::vector<std::vector<bool>> splits;
  for (std::size_t third = 0; third < 3; ++third) {
    std::vector<bool> trains(n, true);
    for (std::size_t i = third * n / 3; i < (third + 1) * n / 3; ++i) trains[i] = false;
    splits.push_back(std::move(trains));
  }
  std::vector<bool> above(n);
  for (std::size_t i = 0; i < n; ++i) above[i] = levels[i].depth_m <= deep_m;
  const auto trained = std::count(above.begin(), above.end(), true);
  if (trained >= 5 && trained < static_cast<std::ptrdiff_t>(n)) splits.push_back(std::move(above));
  return splits;
}

HeldOutScore score_held_out(std::span<const ProfileLevel> levels, const std::vector<bool>& trains,
                            Angle latitude, const ProfileFitOptions& options) {
  check(levels);
  const Split parts = split(levels, trains);
  const FittedProfile fit = fit_profile(parts.training, latitude, options);
  double sum = 0;
  double sum_constant = 0;
  for (const ProfileLevel& level : parts.held_out) {
    sum += std::norm(level.current_m_s - to_horizontal(fit.profile.at_depth(level.depth_m)));
    sum_constant += std::norm(level.current_m_s - parts.training_mean);
  }
  const auto count = static_cast<double>(parts.held_out.size());
  return {std::sqrt(sum / count), std::sqrt(sum_constant / count)};
}

HeldOutScore score_held_out_levels(std::span<const ProfileLevel> levels, Angle latitude,
                                   const ProfileFitOptions& options) {
  check(levels);
  double square = 0;
  double square_constant = 0;
  for (const int parity : {0, 1}) {
    const HeldOutScore score =
        score_held_out(levels, training_levels(levels.size(), parity), latitude, options);
    square += score.eps_m_s * score.eps_m_s;
    square_constant += score.eps_constant_m_s * score.eps_constant_m_s;
  }
  return {std::sqrt(square / 2), std::sqrt(square_constant / 2)};
}

}  // namespace slackwater::calibration
