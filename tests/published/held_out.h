#pragma once
#include <span>
#include <vector>

#include "tests/published/fit_profile.h"

namespace slackwater::calibration {

/// What a profile fitted to half of the levels says of the other half.
struct HeldOutScore {
  double eps_m_s = 0;           ///< sqrt(mean |observed - predicted|^2) on held-out levels
  double eps_constant_m_s = 0;  ///< of the mean vector of the same training levels
  /// What the profile takes off the constant's error: 1 is perfect, below 0 is worse; not finite
  /// where all levels are alike.
  [[nodiscard]] double gain() const noexcept { return 1 - eps_m_s / eps_constant_m_s; }
};

/// Whether each of n levels (by depth) trains: every other one, from the first for `parity` 0 and
/// the second for 1; the first and the last always.
[[nodiscard]] std::vector<bool> training_levels(std::size_t n, int parity);

/// Splits that leave whole stretches out: each third of the levels, and, where five levels or more
/// are left to train on, everything below 60 m.
/// @return per split, whether each level trains
[[nodiscard]] std::vector<std::vector<bool>> held_out_bands(std::span<const ProfileLevel> levels);

/// Trains on some levels and scores on the rest.
/// @param trains  per level; at least five train and one does not
/// @throws as `score_held_out_levels`
[[nodiscard]] HeldOutScore score_held_out(std::span<const ProfileLevel> levels,
                                          const std::vector<bool>& trains, Angle latitude,
                                          const ProfileFitOptions& options = {});

/// Trains on every other level and scores on the rest, for both parities; the errors are the root
/// mean square of the two parities.
///
/// @param levels  by increasing depth, at least nine (five train in each parity)
/// @throws as `fit_profile`; Error(invalid_input) for fewer levels or another order.
[[nodiscard]] HeldOutScore score_held_out_levels(std::span<const ProfileLevel> levels,
                                                 Angle latitude,
                                                 const ProfileFitOptions& options = {});

}  // namespace slackwater::calibration
