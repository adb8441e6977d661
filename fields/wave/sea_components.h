#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "fields/wave/sea_state.h"
#include "fields/wave/wave_component.h"

namespace slackwater {

/// How a sea is made of sinusoids.
struct ComponentChoice {
  std::size_t count = 200;
  FrequencyFrame frame = FrequencyFrame::intrinsic;
};

/// What stands for a sea, and what could not.
struct SeaComponents {
  std::vector<WaveComponent> waves;
  /// Variance of the sinusoids that an opposing current blocks (absolute frequencies only), m2.
  double blocked_variance_m2 = 0;
};

/// Sinusoids for a partitioned sea: each partition has its share by height, at least 8, of the
/// frequencies (`divide_variance`, 0.4 to 6 omega_p, the sum of a^2/2 brought to Hs^2/16 exactly);
/// each sinusoid has its own direction (drawn by strata from the spreading) and phase. No two share
/// a frequency, so that the sea is the same everywhere in the mean (no standing patterns of
/// height).
///
/// Random streams of `run_seed`: fields/wave/frequencies, .../directions, .../phases.
///
/// Throws Error(invalid_input) where the current blocks more than 2 % of the variance (1 % of Hs);
/// less is left out and told.
[[nodiscard]] SeaComponents components_of(const PartitionedSea& sea, const WaveWater& water,
                                          std::uint64_t run_seed,
                                          const ComponentChoice& choice = {});

}  // namespace slackwater
