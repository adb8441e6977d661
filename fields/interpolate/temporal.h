#pragma once
#include <optional>
#include <span>

#include "fields/interpolate/column.h"

namespace slackwater {

/// Value of a one-level series at an instant: linear between the centres of neighbouring cells that
/// have values and lie at most `widest_gap` apart; nothing beyond the ends or across a wider gap.
[[nodiscard]] std::optional<Horizontal> value_at(const VectorColumn& series, UtcTime time,
                                                 Duration widest_gap);
[[nodiscard]] std::optional<double> value_at(const ScalarColumn& series, UtcTime time,
                                             Duration widest_gap);

/// Where an ascending list of instants brackets a time: index of the stamp at or before it and the
/// share of the step beyond; nothing outside [front, back].
struct TimePlace {
  std::size_t low = 0;
  double upper = 0;
};
[[nodiscard]] std::optional<TimePlace> place_in(std::span<const UtcTime> stamps,
                                                UtcTime time) noexcept;

/// Exact mean over a cell of the piecewise-linear series through (stamps, values[stamp * stride +
/// offset]); the value itself for an instant. Nothing unless the stamps cover the cell.
[[nodiscard]] std::optional<Horizontal> mean_over(std::span<const UtcTime> stamps,
                                                  std::span<const Horizontal> values,
                                                  std::size_t stride, std::size_t offset,
                                                  const TimeCell& cell);

}  // namespace slackwater
