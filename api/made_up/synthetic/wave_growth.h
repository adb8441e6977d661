#pragma once
#include <cstdint>
#include <vector>

#include "api/made_up/synthetic/weather.h"
#include "fields/base/frame.h"

namespace slackwater::api {

/// The sea surface at one place and time.
struct SyntheticSea {
  double significant_height_m = 0;  ///< Hm0
  double peak_period_s = 0;         ///< of the partition with the higher spectral peak
  double mean_period_tm02_s = 0;
  double from_direction_deg =
      0;  ///< mean over energy, where waves come from, clockwise from true north
  Horizontal stokes_drift_m_s{};  ///< at the surface, towards
};

/// Waves grown from the synthetic wind: a wind sea that relaxes in 5 h to the fetch-limited sea of
/// the present wind (JONSWAP growth, Hasselmann et al. 1973, capped by the fully developed sea of
/// physics section 8), over a fetch of 20 km from the land in the south to 160 km from the open
/// north, and a swell of about 1 m and 11 s from the west. Stokes drift of each partition is that
/// of a monochromatic deep-water wave of its Hm0 and Tm02.
class WaveGrowth {
 public:
  WaveGrowth(const Weather& weather, std::uint64_t run_seed, double first_h, double last_h);
  /// @param offshore_m  distance to the coast, which shelters
  [[nodiscard]] SyntheticSea sea(double offshore_m, double hours) const noexcept;

 private:
  struct State {
    double energy_m2 = 0;  ///< Hm0 squared of the wind sea
    double peak_period_s = 3;
    Horizontal heading{};  ///< unit-like vector, towards, with the memory of the waves
  };
  double first_h_ = 0;
  std::vector<State> states_;  ///< every ten minutes
  double swell_phase_[3]{};
};

}  // namespace slackwater::api
