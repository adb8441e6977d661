#pragma once
#include <string>

#include "fields/base/time.h"

namespace slackwater {

class SeaRealisation;
struct SeaState;
struct WaveWater;

/// One long-crested wave of Airy, as a wave maker has it: eta = H/2 cos(k . x - omega t), a crest
/// at the origin at the epoch.
struct RegularWave {
  double height_m = 0;            ///< H, from trough to crest, > 0
  double period_s = 0;            ///< T > 0, as the moving water sees it
  double from_direction_deg = 0;  ///< clockwise from true north
  bool operator==(const RegularWave&) const = default;
};

/// The highest that a wave of this period stands: H/L = 0.142 tanh(kh), with L = 2 pi/k of linear
/// theory. Source: Miche (1944), Ann. Ponts Chaussees 114; DNV-RP-C205, 3.4.6.
[[nodiscard]] double breaking_height_m(double period_s, double water_depth_m);

/// Its state, for all that goes by one: the sea that has its energy. With a variance of H^2/8
///
///   Hs = 4 sqrt(m0) = sqrt(2) H,   Tp = T.
///
/// (The mean of the highest third of its heights is H: the two are one in no regular wave.)
[[nodiscard]] SeaState state_of(const RegularWave& wave) noexcept;

/// Why there is no such wave: it breaks. With the highest and the shortest that does not, for
/// people; empty: it stands.
[[nodiscard]] std::string why_it_breaks(const RegularWave& wave, double water_depth_m);

/// The sea of that wave alone. @throws Error(invalid_input) for one that breaks
[[nodiscard]] SeaRealisation realise(const RegularWave& wave, const WaveWater& water,
                                     UtcTime epoch);

}  // namespace slackwater
