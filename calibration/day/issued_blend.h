#pragma once
#include "calibration/day/rehearsal.h"

namespace slackwater::calibration {

/// Turns our own forecast of each column into the one that is issued: the blend of the candidates
/// that past verification earned, its spread scaled by what past bands earned. Members keep their
/// departures from the centre. A value that a candidate lacks is blended from the others.
///
/// The weights are those of the lead (`weights_at`), and so is the factor on the spread
/// (`EarnedSpread::scale_at`); a candidate that says nothing at some times
/// loses its weight over the six hours before them, so that nothing jumps as it comes and goes.
/// @param known  what the candidates start from
void issue_blend(ForecastColumn& column, const ColumnData& data, const KnownColumn& known,
                 const ForecastPlan& plan, const Earned& earned);

/// Which of the standard candidates can be made for this day at this column.
[[nodiscard]] std::vector<bool> available_candidates(const ForecastColumn& column,
                                                     const ColumnData& data,
                                                     const KnownColumn& known,
                                                     const ForecastPlan& plan);

}  // namespace slackwater::calibration
