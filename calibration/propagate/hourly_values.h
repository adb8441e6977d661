#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "calibration/propagate/memory_kernel.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The values of a column up to the end of D, with what belongs to each: arrays over cells x
/// levels.
struct HourlyValues {
  std::vector<HourCell> cell;
  Eigen::MatrixXcd value_m_s;        ///< 0 where there is none
  Eigen::MatrixXcd wind_answer_m_s;  ///< 0 where there is no value
  Eigen::MatrixXd error_m2_s2;       ///< stated variance of the vector
  Eigen::Array<bool, Eigen::Dynamic, Eigen::Dynamic> has;
};

/// Gathers the cells that end by the end of D. Those finer than an hour are averaged over the hours
/// counted back from the end of D, (23:00, 24:00] the last, and stand at the mean of their centres:
/// the cost of a memory is cubic in the cells, and within an hour they say the same. Errors of the
/// values of an hour are independent.
///
/// @param wind_answer_m_s  times x levels of the residual; read where there is a value
/// @param sigma_m_s        stated standard deviation of a component of each value, times x levels;
///                         empty: none stated
[[nodiscard]] HourlyValues hourly_values(const VectorColumn& residual,
                                         std::span<const Horizontal> wind_answer_m_s,
                                         UtcTime end_of_day, std::span<const double> sigma_m_s);

}  // namespace slackwater::calibration
