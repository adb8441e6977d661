#pragma once
#include <span>
#include <vector>

#include "calibration/propagate/gaussian_memory.h"
#include "calibration/propagate/spread.h"
#include "calibration/solve/calibration.h"

namespace slackwater::calibration {

/// What a calibrated column remembers under kernels of several livelinesses (Spread), each believed
/// as its evidence on D says: neighbouring levels err together, so that a column has
/// `independent_levels` witnesses. A kernel of less than a hundredth of the likeliest is left out.
class ColumnMemory {
 public:
  ColumnMemory(const Calibration& calibration, UtcTime end_of_day, const Spread& spread);

  /// Mean and variance of a component, times x levels; the kernels' disagreement is in the
  /// variance.
  /// @param driven  the wind's part at these times, m/s
  /// @param mean, variance  zero on entry
  void predict(std::span<const UtcTime> times, std::span<const Horizontal> driven,
               std::vector<Horizontal>& mean, std::vector<double>& variance) const;

  /// The kernel that members are drawn from.
  [[nodiscard]] const GaussianMemory& likeliest() const;

 private:
  std::vector<GaussianMemory> memory_;
  std::vector<double> weight_;
};

}  // namespace slackwater::calibration
