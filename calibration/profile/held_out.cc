#include "calibration/profile/held_out.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "fields/base/check.h"
#include "fields/base/error.h"

namespace slackwater::calibration {
namespace {

constexpr std::size_t fewest_levels = 9;

struct Split {
  std::vector<ProfileLevel> training, held_out;
  Horizontal training_mean;
};

Split split(std::span<const ProfileLevel> levels, int parity) {
  const std::vector<bool> trains = training_levels(levels.size(), parity);
  Split parts;
  for (std::size_t i = 0; i < levels.size(); ++i)
    (trains[i] ? parts.training : parts.held_out).push_back(levels[i]);
  for (const ProfileLevel& level : parts.training) parts.training_mean += level.current_m_s;
  parts.training_mean /= static_cast<double>(parts.training.size());
  return parts;
}

void check(std::span<const ProfileLevel> levels) {
  if (levels.size() < fewest_levels) {
    throw Error(ErrorKind::invalid_input,
                "profile has " + std::to_string(levels.size()) + " levels: expected at least " +
                    std::to_string(fewest_levels) + " so that five train in each parity");
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

HeldOutScore score_held_out_levels(std::span<const ProfileLevel> levels, Angle latitude,
                                   const ProfileFitOptions& options) {
  check(levels);
  double square = 0;
  double square_constant = 0;
  for (const int parity : {0, 1}) {
    const Split parts = split(levels, parity);
    const FittedProfile fit = fit_profile(parts.training, latitude, options);
    double sum = 0;
    double sum_constant = 0;
    for (const ProfileLevel& level : parts.held_out) {
      sum += std::norm(level.current_m_s - to_horizontal(fit.profile.at_depth(level.depth_m)));
      sum_constant += std::norm(level.current_m_s - parts.training_mean);
    }
    square += sum / static_cast<double>(parts.held_out.size());
    square_constant += sum_constant / static_cast<double>(parts.held_out.size());
  }
  return {std::sqrt(square / 2), std::sqrt(square_constant / 2)};
}

}  // namespace slackwater::calibration
