#pragma once
#include <optional>
#include <span>
#include <string>
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

  /// sqrt(sum Hs^2).
  [[nodiscard]] double significant_height_m() const noexcept;
  /// Period of the partition with the highest spectral peak (Hs^2 Tp); 0 for a calm sea.
  [[nodiscard]] double peak_period_s() const noexcept;
};

/// Sp = 2 pi Hs/(g Tp^2).
[[nodiscard]] double steepness_of(double significant_height_m, double peak_period_s) noexcept;

/// A sea that somebody made up, for a scenario. It must be one that can exist: every partition, and
/// the total at the period of its highest peak, stays below `steepest_height_m` (growth.h).
///
/// Throws Error(invalid_input), with what was found, the limit and what would do, for a sea that is
/// too steep, a height below 0 or not finite, a period that is not above 0, a gamma outside [1, 10],
/// an s outside [0, 1000], a direction outside [-360, 360]; `what` names the sea in the message.
[[nodiscard]] PartitionedSea scenario_sea(std::span<const WavePartition> partitions,
                                          const std::string& what);

/// A sea as served, with what had to be said about it.
struct ServedSea {
  PartitionedSea sea;
  std::vector<std::string> warnings;
};

/// A sea out of a product, whose total height is what the product vouches for and whose partitions
/// are its own decomposition of it.
///
/// - A partition steeper than the limit is lowered to it, with a warning.
/// - Then the energies are rescaled to the total, Hs^2 = sum Hs_i^2: down in proportion, up only as
///   far as each partition's limit; a warning says so where the total changes by more than 2 %.
/// - A total that the limits of all partitions cannot carry is served as it stands, all partitions
///   raised in proportion, with a warning.
/// - Partitions without a finite height above 0, period above 0 and finite direction are left out,
///   with a warning unless the height is 0 or the partition is wholly absent (all NaN); if none is
///   left the sea is calm (no partitions).
///
/// @param total_height_m  the product's total Hs; NaN: the sum of the partitions stands for it
[[nodiscard]] ServedSea product_sea(double total_height_m,
                                    std::span<const WavePartition> partitions);

}  // namespace slackwater
