#pragma once
#include <vector>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/calibration.h"
#include "calibration/solve/observations.h"

namespace slackwater::calibration {

/// Observation minus model on the axes of the observed column; status missing where there was no
/// pair.
[[nodiscard]] VectorColumn residual_column(const VectorColumn& current,
                                           const Observations& observations,
                                           const ColumnRows::Matrix& model);

/// Rms and bias by depth, levels without a value left out.
[[nodiscard]] std::vector<MisfitAtDepth> misfit_by_depth(const VectorColumn& residual,
                                                         const std::vector<double>& depth_m);

/// sqrt(mean |residual|^2) over everything that has a value.
[[nodiscard]] double rms_m_s(const VectorColumn& residual);

/// Standard deviation of one component of the residual by its median modulus, which bad values
/// hardly move: the modulus of two normal components of deviation sigma has the median sigma sqrt(2
/// ln 2).
[[nodiscard]] double robust_component_sigma_m_s(const VectorColumn& residual);

}  // namespace slackwater::calibration
