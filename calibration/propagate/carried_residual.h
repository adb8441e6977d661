#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/propagate.h"

namespace slackwater::calibration {

/// What the misfit of D says about later, at asked depths.
struct CarriedResidual {
  std::vector<Horizontal> bias_m_s;         ///< constant part of D's residual
  std::vector<Horizontal> oscillation_m_s;  ///< its free inertial oscillation, at the end of D
  std::vector<Horizontal> recent_m_s;       ///< mean of what is left over in the last hours
  std::vector<double> misfit_sigma_m_s;     ///< standard deviation of a component about zero
  double age_h = 0;                         ///< of the last residual, at the end of D
};

/// Splits the residual of each level into a constant, a free inertial oscillation
/// (inertial_memory.h) and what is left over in the last hours, and interpolates them and the misfit
/// to the depths. A level without a value in the last hours has nothing left over.
[[nodiscard]] CarriedResidual carried_residual(const Calibration& calibration,
                                               std::span<const double> depths_m, UtcTime end_of_day,
                                               const PropagationSettings& settings);

}  // namespace slackwater::calibration
