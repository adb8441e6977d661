#pragma once
#include <optional>

#include "calibration/skill/history.h"
#include "fields/current/tide.h"

namespace slackwater::calibration {

/// Mean + M2 S2 K1 O1 M4, both senses of rotation, over the last 15 days before the end of D;
/// nothing where the series is shorter than 15 days or holds fewer than the 11 values that its
/// unknowns need.
[[nodiscard]] std::optional<TideFit> tide_of_last_15_days(const LevelSeries& series, UtcDay day);

}  // namespace slackwater::calibration
