#pragma once
#include <optional>
#include <span>
#include <vector>

#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// A time without wind that is too long to be crossed on a line (fields/record/cadence.h).
struct WindGap {
  UtcTime from{};  ///< the last value before it; where there is none, the first stamp
  UtcTime to{};    ///< the first value after it
  bool operator==(const WindGap&) const = default;
};

/// The wind at stamps, from a series with gaps.
struct FilledWind {
  std::vector<Horizontal> wind_m_s;  ///< at the stamps
  std::vector<DataStatus> source;    ///< per stamp; `persisted` where it is not from the series
  /// Standard deviation of a component per stamp for standing in a hole or a gap, 0 elsewhere.
  std::vector<double> hole_sigma_m_s;
  std::vector<WindGap> gaps;  ///< those that any stamp lies in, before the last value
  /// The series, hourly where its steps are wide, with the stamps where it has nothing.
  VectorColumn series;
};

/// Fills a wind for the times of a forecast.
///
/// Within steps and short pauses it lies on the line between its neighbours. In a gap, and beyond
/// the last value, the last one before it fades to the mean of what was known up to there, with the
/// memory of the wind; in the last six hours of a gap the wind goes back on a line to the first
/// value after it. Before the first value of all it is the mean of the series, and goes to that
/// value likewise. A value after a gap is nowhere copied into it.
///
/// In a hole (a pause wider than the steps beside it) the wind is uncertain as one that is
/// persisted from both sides, 1/s^2 = 1/s_before^2 + 1/s_after^2; in a gap as persisted from
/// before.
///
/// @param series  at least one value; all have one, instants, ascending
/// @param stamps  ascending
[[nodiscard]] FilledWind fill_wind(const VectorColumn& series, std::span<const UtcTime> stamps);

}  // namespace slackwater::calibration
