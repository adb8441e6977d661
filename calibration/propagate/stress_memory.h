#pragma once
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/current/stress_series.h"

namespace slackwater::calibration {

/// The wind stress at whole hours about the end of D, and where it is known.
struct HourlyStress {
  UtcTime first{};
  std::vector<Horizontal> stress_pa;  ///< 0 where unknown
  std::vector<bool> is_known;

  /// From `history_h` before to `lead_h` after (rounded up to the hour) the end of D.
  [[nodiscard]] static HourlyStress sample(const StressSeries& series, UtcTime end_of_day,
                                           double history_h, double lead_h);
};

/// What a damped, turning mode still remembers of the changes of the wind stress, Pa:
///
///   m(t) = Int e^{-lambda (t - s)} dT/ds ds,   lambda = r + i f
///
/// so that T - m is the stress as the mode feels it: behind time and turned. Exact for a stress that
/// is linear within each hour. Before the first hour, and over an hour whose stress is unknown at
/// either end, the stress is taken not to change: a gap makes no oscillation. Constant wind: m = 0.
class StressMemory {
 public:
  /// @param lambda_per_h  real part > 0
  StressMemory(const HourlyStress& stress, Horizontal lambda_per_h);

  /// m at an instant, or its exact mean over the interval.
  [[nodiscard]] Horizontal over(const TimeCell& cell) const;

 private:
  struct At {
    Horizontal value{};
    Horizontal integral_h{};  ///< of m since the first hour, Pa h
  };
  [[nodiscard]] At at(UtcTime time) const;

  UtcTime first_;
  Horizontal lambda_per_h_;
  std::vector<Horizontal> slope_pa_h_;  ///< within the hour that begins there; 0 after the last
  std::vector<At> knot_;
};

}  // namespace slackwater::calibration
