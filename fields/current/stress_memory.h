#pragma once
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/current/stress_series.h"

namespace slackwater {

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
  /// m and its derivative by lambda (holomorphic), Pa and Pa h.
  struct Value {
    Horizontal memory_pa{};
    Horizontal by_lambda_pa_h{};
  };

  /// @param lambda_per_h  real part > 0
  StressMemory(const HourlyStress& stress, Horizontal lambda_per_h);

  /// At an instant, or the exact mean over the interval.
  [[nodiscard]] Value over(const TimeCell& cell) const;

 private:
  /// m, d m/d lambda, and their integrals since the first hour.
  struct Knot {
    Value value;
    Value integral_h;
  };
  [[nodiscard]] Knot step(const Knot& from, Horizontal slope_pa_h, double hours,
                          Horizontal decay) const;
  [[nodiscard]] Knot at(UtcTime time) const;

  UtcTime first_;
  Horizontal lambda_per_h_;
  Horizontal inverse_lambda_h_;
  std::vector<Horizontal> slope_pa_h_;  ///< within the hour that begins there; 0 after the last
  std::vector<Knot> knot_;
};

}  // namespace slackwater
