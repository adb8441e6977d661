#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// The tide of the recipes: mean + M2 S2 K1 O1 M4, both senses of rotation, by least squares over
/// the last 15 days before the end of D, at every level of a column; a level whose record is
/// shorter than 15 days, or holds fewer than the 11 values that its unknowns need, has none.
///
/// Values that are means are fitted as means. Where the sampling cannot tell constituents apart
/// (S2 in 6-hourly values) the solution of smallest norm is taken. Levels with the same times share
/// one factorisation: a column costs little more than a level.
class ColumnTide {
 public:
  /// @param since  values before lack the tide and are not looked at
  ColumnTide(const VectorColumn& history, UtcDay day, UtcTime since = UtcTime::min());

  [[nodiscard]] bool has(std::size_t level) const noexcept { return level_[level].has_value(); }
  /// Of the 15 days, fitted together with the tide. Only where `has(level)`.
  [[nodiscard]] Horizontal mean(std::size_t level) const { return level_[level]->front(); }
  /// The tide without the mean, at instants or as the exact averages over means, m/s: cells x
  /// levels, level fastest; 0 where a level has none.
  [[nodiscard]] std::vector<Horizontal> oscillation(std::span<const TimeCell> cells) const;

 private:
  static constexpr std::size_t unknowns = 11;
  using Coefficients = std::array<Horizontal, unknowns>;  ///< mean, then W+ and W- of each
  UtcTime reference_;
  std::vector<std::optional<Coefficients>> level_;
};

}  // namespace slackwater::calibration
