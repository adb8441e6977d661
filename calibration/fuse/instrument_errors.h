#pragma once
#include <vector>

namespace slackwater::calibration {

/// What the values of one instrument are worth, beyond what `FusionSettings` state of all. Standard
/// deviations of one component.
struct MooredInstrumentErrors {
  /// Of one sample, independent of the next (pings, turbulence), per level; it averages out over a
  /// mean. Empty, or less than the settings' `instrument_error_m_s`: that.
  std::vector<double> noise_m_s;
  /// What stays for days and does not average out (mounting, compass, zero).
  double lasting_m_s = 0;
};

}  // namespace slackwater::calibration
