#pragma once
#include <span>
#include <vector>

#include "calibration/residuals/column_rows.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// The model of a calibrated day at the instants of a horizon, under a stress that may be unknown
/// at some (0 there).
[[nodiscard]] ColumnDay day_of_horizon(const Calibration& calibration,
                                       std::span<const UtcTime> times, UtcTime end_of_day,
                                       const StressSeries& stress);

/// The wind-driven part of one form under any wind and parameters, at fixed times and levels.
class WindDriven {
 public:
  WindDriven(const Calibration& calibration, std::span<const UtcTime> times, UtcTime end_of_day);

  /// m/s, times x levels. Without a stress at a time its instantaneous part is left out.
  [[nodiscard]] std::vector<Horizontal> under(const StressSeries& stress,
                                              const SteadyParameters& parameters);

 private:
  const Calibration& calibration_;
  std::span<const UtcTime> times_;
  UtcTime end_of_day_;
  ColumnRows rows_;
};

/// The parameters of the forward model drawn from their posterior: of a vector of standard normals,
/// one a parameter. Interior and other flow stay at their estimate.
[[nodiscard]] SteadyParameters drawn_parameters(const Calibration& calibration,
                                                std::span<const double> normals);

/// The wind with a departure added to each sample after the end of D.
[[nodiscard]] VectorColumn departed_wind(const VectorColumn& wind, UtcTime end_of_day,
                                         std::span<const Horizontal> departures);

}  // namespace slackwater::calibration
