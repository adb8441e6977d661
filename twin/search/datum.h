#pragma once
#include "twin/search/leeway.h"

namespace slackwater::twin {

/// Where somebody adrift is thought to be: the last known position, carried along the drift that is
/// forecast there. A search that is laid out about the datum moves with it.
/// Source: IAMSAR manual, volume II, 4 (datum) and volume III, 3 (patterns made good relative to
/// the drifting object).
struct DatumState {
  Triple<double> drifted_m;     ///< from the last known position, as of `at_s`
  Triple<double> velocity_m_s;  ///< since then
  double at_s = 0;

  [[nodiscard]] Triple<double> drifted_at(double t_s) const noexcept {
    return drifted_m + (t_s - at_s) * velocity_m_s;
  }
};

/// The drift that is to be expected: the current and the leeway of the object's kind, half of them
/// to either side of downwind.
[[nodiscard]] Triple<double> expected_drift(const LeewayObject& object,
                                            const Triple<double>& current_m_s,
                                            const Triple<double>& wind_10m_m_s) noexcept;

/// Goes on with another velocity from now on.
void turn_datum(const Triple<double>& velocity_m_s, double t_s, DatumState& state) noexcept;

}  // namespace slackwater::twin
