#pragma once
#include <optional>
#include <vector>

#include "fields/wave/spectrum.h"

namespace slackwater {

/// One system of waves: the sea under the wind, or a swell.
struct WavePartition {
  double significant_height_m = 0;  ///< >= 0
  double peak_period_s = 0;         ///< > 0
  double from_direction_deg = 0;    ///< mean direction, clockwise from true north
  std::optional<double> gamma{};    ///< peak enhancement, 1 to 10; by `dnv_gamma` where not given
  /// Spreading exponent s of the half-angle form (spreading.h). 10 is a spread of 24 degrees, a
  /// young wind sea at its peak (Mitsuyasu et al. 1975); swell is narrower, 25 (16 degrees) and up.
  double spreading_s = 10;

  [[nodiscard]] JonswapSpectrum spectrum() const;
  bool operator==(const WavePartition&) const = default;
};

/// A sea of several systems, whose energies add.
struct PartitionedSea {
  std::vector<WavePartition> partitions;
  bool operator==(const PartitionedSea&) const = default;

  /// sqrt(sum Hs^2).
  [[nodiscard]] double significant_height_m() const noexcept;
  /// The partition with the highest spectral peak (Hs^2 Tp), the first of them; null: a calm sea.
  [[nodiscard]] const WavePartition* highest_peak() const noexcept;
  /// Its period and mean direction; 0 for a calm sea.
  [[nodiscard]] double peak_period_s() const noexcept;
  [[nodiscard]] double from_direction_deg() const noexcept;
};

/// Sp = 2 pi Hs/(g Tp^2).
[[nodiscard]] double steepness_of(double significant_height_m, double peak_period_s) noexcept;

}  // namespace slackwater
