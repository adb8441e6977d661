#pragma once
#include <memory>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/current/complex.h"
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

/// How the stress changes from hour to hour: all that a mode remembers of it, and the same for
/// every mode. Before the first hour, and over an hour whose stress is unknown at either end, the
/// stress is taken not to change: a gap makes no oscillation.
class StressChanges {
 public:
  /// An instant among the hours: the last whole hour at or before it, and the rest.
  struct Place {
    std::size_t hour = 0;
    double part_h = 0;
  };

  explicit StressChanges(const HourlyStress& stress);

  [[nodiscard]] std::size_t hours() const noexcept { return slope_pa_h_.size(); }
  /// Within the hour that begins there; 0 after the last.
  [[nodiscard]] const Complex<double>& slope_pa_h(std::size_t hour) const {
    return slope_pa_h_[hour];
  }
  [[nodiscard]] Place place_of(UtcTime time) const;
  /// By how much the stress has changed since the first hour.
  [[nodiscard]] Complex<double> since_first_pa(const Place& place) const;

 private:
  UtcTime first_;
  std::vector<Complex<double>> slope_pa_h_;
  std::vector<Complex<double>> since_first_pa_;
};

/// What a damped, turning mode still remembers of the changes of the wind stress, Pa:
///
///   m(t) = Int e^{-lambda (t - s)} dT/ds ds,   lambda = r + i f
///
/// so that T - m is the stress as the mode feels it: behind time and turned. Exact for a stress
/// that is linear within each hour. Constant wind: m = 0.
class StressMemory {
 public:
  /// m and its derivative by lambda (holomorphic), Pa and Pa h.
  struct Value {
    Horizontal memory_pa{};
    Horizontal by_lambda_pa_h{};
  };

  /// @param lambda_per_h  real part > 0
  StressMemory(std::shared_ptr<const StressChanges> changes, Horizontal lambda_per_h);
  StressMemory(const HourlyStress& stress, Horizontal lambda_per_h)
      : StressMemory(std::make_shared<const StressChanges>(stress), lambda_per_h) {}

  /// At an instant, or the exact mean over the interval.
  [[nodiscard]] Value over(const TimeCell& cell) const;

 private:
  struct Knot {
    Complex<double> memory_pa;
    Complex<double> by_lambda_pa_h;
  };
  /// What a stretch of constant slope does to m, and the same differentiated by lambda.
  struct Stretch;
  [[nodiscard]] Knot at(const StressChanges::Place& place) const;

  std::shared_ptr<const StressChanges> changes_;
  Complex<double> lambda_per_h_;
  Complex<double> inverse_lambda_h_;
  std::vector<Knot> knot_;  ///< at the whole hours
};

}  // namespace slackwater
