#pragma once
#include <optional>

#include "fields/base/frame.h"

namespace slackwater {

/// One long-crested linear wave, eta = a cos(k . x - omega t + epsilon).
struct WaveComponent {
  double amplitude_m = 0;       ///< a
  double intrinsic_rad_s = 0;   ///< sigma, as the moving water sees it: sigma^2 = g k tanh kh
  double absolute_rad_s = 0;    ///< omega = sigma + k . U, as a fixed place sees it
  Horizontal wavenumber_rad_m;  ///< k, towards, east + i north; not 0
  double phase_rad = 0;         ///< epsilon
};

/// The water that the waves travel through.
struct WaveWater {
  double depth_m = 0;        ///< h > 0, still water
  Horizontal current_m_s{};  ///< U, towards, the same from surface to bed
  bool operator==(const WaveWater&) const = default;
};

/// Whose frequencies a spectrum is written in. Wave models without currents, and growth laws, mean
/// the intrinsic one; what is measured from a moored buoy, mast or pile is the absolute one.
enum class FrequencyFrame { intrinsic, absolute };

/// The wave of an amplitude, a frequency and a mean direction, in such water.
///
/// @param frequency_rad_s     > 0, in the frame that is named
/// @param from_direction_deg  clockwise from true north
/// @return nothing where the current blocks the wave (absolute frequencies only)
[[nodiscard]] std::optional<WaveComponent> wave_component(double amplitude_m,
                                                          double frequency_rad_s,
                                                          FrequencyFrame frame,
                                                          double from_direction_deg,
                                                          double phase_rad, const WaveWater& water);

}  // namespace slackwater
