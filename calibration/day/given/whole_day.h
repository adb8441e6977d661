#pragma once
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// Whether a day's currents are there: no gap at its ends or within it wider than two and a half
/// usual steps (of two and a half hours for series finer than hourly).
[[nodiscard]] bool holds_throughout(const VectorColumn& currents, UtcDay day);

}  // namespace slackwater::calibration
