#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/propagate.h"

namespace slackwater::calibration {

/// What the misfit of D says about later, at asked depths.
struct CarriedResidual {
  std::vector<Horizontal> bias_m_s;      ///< mean residual of D
  std::vector<Horizontal> recent_m_s;    ///< mean residual of its last hours
  std::vector<double> misfit_sigma_m_s;  ///< standard deviation of a component about zero
  double age_h = 0;                      ///< of the last residual, at the end of D
};

/// Reads bias, recent residual and misfit per level and interpolates them to the depths. A level
/// without a value in the last hours keeps its bias alone (recent = bias).
[[nodiscard]] CarriedResidual carried_residual(const Calibration& calibration,
                                               std::span<const double> depths_m, UtcTime end_of_day,
                                               double recent_h);

}  // namespace slackwater::calibration
