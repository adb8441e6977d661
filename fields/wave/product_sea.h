#pragma once
#include <span>
#include <string>
#include <vector>

#include "fields/wave/sea_state.h"

namespace slackwater {

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
