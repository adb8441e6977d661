#pragma once
#include <optional>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/current/wind_stress.h"
#include "fields/interpolate/column.h"

namespace slackwater {

/// The wind stress as a continuous function of time, made from the samples of a 10 m wind column.
///
/// Linear between samples (a mean stands at the middle of its interval), component by component,
/// over gaps of at most `longest_gap`; held for at most `longest_hold` before the first and after
/// the last sample. Elsewhere there is no value: a missing wind never becomes calm air. Gap and
/// hold cover the coarsest wind products (6-hourly), no more.
class StressSeries {
 public:
  static constexpr Duration longest_gap = std::chrono::hours(6);
  static constexpr Duration longest_hold = std::chrono::hours(3);

  /// No samples: no value at any time.
  StressSeries() = default;
  /// Takes level 0 of the column; samples without a finite value are skipped.
  StressSeries(const VectorColumn& wind_10m, DragLaw law);

  [[nodiscard]] bool empty() const noexcept { return time_.empty(); }
  /// Stress at an instant, Pa, towards.
  [[nodiscard]] std::optional<Horizontal> at(UtcTime time) const;
  /// Stress of an instant, or its exact mean over the interval; none where any part of it has no
  /// value.
  [[nodiscard]] std::optional<Horizontal> over(const TimeCell& cell) const;

 private:
  std::vector<UtcTime> time_;
  std::vector<Horizontal> stress_pa_;
};

}  // namespace slackwater
