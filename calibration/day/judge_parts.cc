#include "calibration/day/judge_parts.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

bool has_any_value(const DailyForecast& result) {
  return std::any_of(result.columns.begin(), result.columns.end(), [](const ColumnForecast& made) {
    const ForecastColumn& column = made.column;
    return !column.wind_m_s.empty() ||
           std::any_of(column.sea.begin(), column.sea.end(),
                       [](const SeaState& s) { return std::isfinite(s.significant_height_m); }) ||
           std::any_of(column.current_status.begin(), column.current_status.end(), has_value);
  });
}

}  // namespace

void judge_parts(const DailyForecast& result, std::vector<std::string>& troubles) {
  const std::size_t all = result.columns.size();
  for (const PartFailure& failed : result.failures)
    troubles.push_back(failure_text(failed, all, all));
  std::map<Part, std::vector<const PartFailure*>> by_part;
  for (const ColumnForecast& column : result.columns) {
    for (const PartFailure& failed : column.failures) by_part[failed.part].push_back(&failed);
  }
  for (const auto& [part, failed] : by_part) {
    // A column without a current alone is named by `judge_columns`.
    const bool is_named = loses_the_current(part) && part != Part::column;
    if (!is_named) troubles.push_back(failure_text(*failed.front(), failed.size(), all));
  }
  if (result.earned && result.earned->first_failure) {
    troubles.push_back(
        "the rehearsal of " + std::to_string(result.earned->failed_days) +
        (result.earned->failed_days == 1 ? " past day" : " past days") +
        " failed, the blend rests on the others: " + result.earned->first_failure->why);
  }
}

void expect_any_value(const DailyForecast& result, const std::vector<std::string>& troubles) {
  if (has_any_value(result)) return;
  ErrorKind kind = ErrorKind::not_found;
  const auto look_at = [&](const std::vector<PartFailure>& failures) {
    for (const PartFailure& failed : failures) kind = failed.failure.kind;
  };
  for (const ColumnForecast& column : result.columns) look_at(column.failures);
  look_at(result.failures);
  throw Error(kind, "nothing can be forecast for " + format_day(result.plan.day) + ": " +
                        joined(troubles, "; "));
}

}  // namespace slackwater::calibration
