#pragma once
#include <vector>

#include "twin/sensor/dvl.h"

namespace slackwater::twin {

/// An acoustic Doppler current profiler that looks at the served water itself: four Janus beams, in
/// each of which the speed along the beam is averaged over bins of range with the triangular weight
/// of a pulse as long as a bin.
///
/// - The first bin's centre lies `blanking_m` and a bin along the axis.
/// - A single ping of a beam has white noise; n pings leave it 1/sqrt n of that.
/// - A beam knows a speed only within +-`ambiguity_m_s`: what is faster is folded back.
/// - Echoes of side lobes from the surface (looking up) or the bed spoil the last 1 - cos(slant) of
///   the way to it: bins whose triangle reaches there have no value.
/// - The beams stand apart: the flow is taken to be alike in all at one range, also where the
///   instrument tilts (bins are not mapped to levels).
///
/// Source: Gordon, Acoustic Doppler Current Profilers: principles of operation, a practical primer
/// (RD Instruments 1996). Defaults: the kind of a Workhorse 600 kHz; noise for bins of 1 m, an
/// estimate from its primer.
struct Adcp {
  double slant_rad = 0.3490658503988659;  ///< 20 degrees
  double azimuth_rad = 0;
  bool looks_up = true;
  double bin_m = 1;
  double blanking_m = 0.9;
  int bins = 40;
  int pings = 50;               ///< averaged in one profile
  double noise_sd_m_s = 0.064;  ///< of one beam, one ping
  double ambiguity_m_s = 1.75;
};

struct AdcpBin {
  double down_m = 0;  ///< z of its centre
  /// Of the water, NED; nothing where the bin is spoilt or a beam met something.
  std::optional<Triple<double>> velocity_m_s;
  double error_m_s = 0;
};

/// One averaged profile by an instrument that is held still during it, or moves at `velocity_m_s`,
/// which is taken out.
[[nodiscard]] std::vector<AdcpBin> measured(const Adcp& adcp, NoiseStream& noise,
                                            const Scene& scene, const WaterAt& water,
                                            const Triple<double>& at_m, const Rotation<double>& r,
                                            const Triple<double>& velocity_m_s);

/// Speed as a Doppler instrument shows it: folded into [-ambiguity, ambiguity).
[[nodiscard]] double folded(double speed_m_s, double ambiguity_m_s) noexcept;

}  // namespace slackwater::twin
