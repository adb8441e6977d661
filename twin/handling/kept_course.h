#pragma once
#include <optional>

#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// How a vehicle that swims or floats keeps its course, and its depth, under its own autopilot, in
/// still and deep water: begun 10 degrees beside the course at the speed that it is to keep, for
/// twelve periods of its slowest loop (1 to 10 min). Of the second half.
struct KeptCourse {
  double speed_m_s = 0;  ///< to be kept
  double lasts_s = 0;    ///< all of it
  /// Whether that is long enough to judge it by: six periods of its slowest loop. Of one that went
  /// over in the first half there is nothing to judge either.
  bool is_judged = false;
  double heading_off_rad = 0;    ///< at most, of its size
  double depth_off_m = 0;        ///< likewise; 0 of what floats
  double heading_swing_rad = 0;  ///< from the least to the greatest
  double pitch_swing_rad = 0;
  double made_m_s = 0;              ///< ahead, mean
  std::optional<double> over_at_s;  ///< when it rolled or pitched beyond a right angle, or its
                                    ///< state was no number any more; the rest is of before that
  friend bool operator==(const KeptCourse&, const KeptCourse&) = default;
};

/// @param autopilot  of the vehicle at `usual_voltage_v`
/// Cost: one to four milliseconds.
/// @throws ContractViolation for a multirotor, which has no course to keep
[[nodiscard]] KeptCourse kept_course(const Vehicle& vehicle, const Autopilot& autopilot,
                                     double speed_m_s);

/// Within 5 degrees of its course and 1 m of its depth, and it has not gone over.
[[nodiscard]] bool is_kept(const KeptCourse& course) noexcept;
/// Beyond 20 degrees or 3 m, or it has gone over.
[[nodiscard]] bool is_lost(const KeptCourse& course) noexcept;

}  // namespace slackwater::twin
