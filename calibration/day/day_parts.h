#pragma once
#include <functional>
#include <vector>

#include "calibration/day/column/unresolved_tide.h"
#include "calibration/day/earned_heights.h"
#include "calibration/day/forecast_column.h"
#include "calibration/day/given/stand_in.h"
#include "calibration/day/issued_blend.h"
#include "calibration/day/leading_day.h"
#include "calibration/day/rehearsal.h"

namespace slackwater::calibration {

/// The work on a day's forecast by its parts, each of which may fail without the others
/// (part_failure.h). Those that stand here do the work; tests put others in their place to see one
/// fail. A part that is replaced has to be safe to call from many threads.
struct DayParts {
  std::function<decltype(leading_day)> day = leading_day;
  ColumnParts of_column;
  std::function<decltype(forecast_column)> column = forecast_column;
  std::function<decltype(earned_heights)> heights = earned_heights;
  std::function<Earned(RehearsedDays&, const ForecastPlan&, const std::vector<bool>&, int)>
      rehearsal = &RehearsedDays::earned;
  std::function<decltype(issue_blend)> blend = issue_blend;
  std::function<decltype(widen_by_unresolved_tide)> unresolved_tide = widen_by_unresolved_tide;
  std::function<decltype(widen_by_stand_in)> stand_in = widen_by_stand_in;
};

}  // namespace slackwater::calibration
