#include "fields/wave/wave_component.h"

#include "fields/wave/dispersion.h"

namespace slackwater {

std::optional<WaveComponent> wave_component(double amplitude_m, double frequency_rad_s,
                                            FrequencyFrame frame, double from_direction_deg,
                                            double phase_rad, const WaveWater& water) {
  const Horizontal towards = vector_from_direction(1.0, from_direction_deg);
  const double along_m_s = (std::conj(towards) * water.current_m_s).real();
  WaveComponent wave;
  wave.amplitude_m = amplitude_m;
  wave.phase_rad = phase_rad;
  double k = 0;
  if (frame == FrequencyFrame::intrinsic) {
    k = wavenumber_rad_m(frequency_rad_s, water.depth_m);
    wave.intrinsic_rad_s = frequency_rad_s;
    wave.absolute_rad_s = frequency_rad_s + k * along_m_s;
  } else {
    const auto found = wavenumber_in_current_rad_m(frequency_rad_s, water.depth_m, along_m_s);
    if (!found) return std::nullopt;
    k = *found;
    wave.intrinsic_rad_s = intrinsic_frequency_rad_s(k, water.depth_m);
    wave.absolute_rad_s = frequency_rad_s;
  }
  wave.wavenumber_rad_m = k * towards;
  return wave;
}

}  // namespace slackwater
