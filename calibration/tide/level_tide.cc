#include "calibration/tide/level_tide.h"

#include <vector>

namespace slackwater::calibration {

TideFit fit_level_tide(std::span<const TimeCell> time, std::span<const double> value_m,
                       std::span<const SampleStatus> status) {
  const std::vector<Horizontal> along(value_m.begin(), value_m.end());
  // At the equator inertial motion has no frequency that a tide could be taken for.
  const Angle equator = Angle::from_degrees(0);
  return fit_tide(time, along, status, equator);
}

double level_over(const TideFit& fit, const TimeCell& cell) noexcept {
  return tide_over(fit, cell).real();
}

}  // namespace slackwater::calibration
