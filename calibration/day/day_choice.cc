#include "calibration/day/day_choice.h"

#include <algorithm>

#include "calibration/day/leading_day.h"
#include "fields/base/error.h"

namespace slackwater::calibration {

namespace {

using std::chrono::days;
using std::chrono::hours;

/// A forecast reaches this far beyond the end of the day it was fitted on, at most.
constexpr int longest_lead_days = 40;

/// Levels of the dataset that are wet at any column.
std::vector<double> wet_levels(const SiteData& data, const std::string& dataset) {
  std::vector<double> levels;
  std::size_t deepest = 0;
  for (const ColumnData& column : data.columns) {
    for (const auto& piece : column.current.pieces) {
      if (piece.origin->dataset != dataset) continue;
      levels = piece.column.levels_m;
      for (std::size_t k = deepest; k < levels.size(); ++k) {
        for (std::size_t t = 0; t < piece.column.times(); ++t) {
          if (piece.column.has(t, k)) {
            deepest = k + 1;
            break;
          }
        }
      }
    }
  }
  if (levels.empty())
    return {0.0};  // a surface product without a depth: its one level is the surface
  levels.resize(deepest);
  return levels;
}

std::vector<UtcTime> hourly(UtcTime from, UtcTime to) {
  std::vector<UtcTime> stamps;
  for (UtcTime stamp = from; stamp <= to; stamp += hours(1)) stamps.push_back(stamp);
  return stamps;
}

}  // namespace

DayChoice choose_day(const SiteData& data, const ForecastOptions& options,
                     std::vector<PartFailure>& failures) {
  DayChoice choice;
  attempt_part(Part::day, failures, [&] {
    const DaysKnown known{options.issued, options.seen_by, options.day};
    const std::optional<LeadingDay> leading = options.parts.day(data, known);
    if (!leading) return;
    choice.averaging = leading->averaging;
    choice.dataset = leading->dataset;
    choice.stands_in_for = leading->stands_in_for;
    choice.usable = leading->day;
  });
  // Providers deliver a day late; more than that is late, and the forecast still has to reach as
  // far.
  const UtcDay newest_possible = day_of(options.issued) - days(1);
  choice.wanted = options.day.value_or(
      std::max(choice.usable.value_or(newest_possible), newest_possible - days(1)));
  return choice;
}

ForecastPlan plan_of(const SiteData& data, const ForecastOptions& options,
                     const DayChoice& choice) {
  ForecastPlan plan;
  plan.day = choice.usable.value_or(choice.wanted);
  plan.issued = options.issued;
  plan.wind = options.wind;
  plan.seen_by = options.seen_by;
  plan.best = {options.issued, options.hindsight, options.issued,
               options.hindsight ? UtcTime::max() : options.seen_by};
  plan.seed = options.seed;
  plan.spread.members = options.members;
  if (options.simulate_wind) plan.best.simulated_seed = options.seed;
  plan.stamps = hourly(plan.end_of_day(), UtcTime(choice.wanted) + days(1) + options.horizon);
  plan.dataset = choice.dataset;
  plan.stands_in_for = choice.stands_in_for;
  if (choice.usable) plan.depth_m = wet_levels(data, plan.dataset);
  if (plan.stamps.size() > std::size_t{24} * longest_lead_days) {
    throw Error(ErrorKind::not_found,
                "the newest usable day of currents is " + format_day(plan.day) +
                    "; a forecast from it for " + format_day(choice.wanted) +
                    " would have a lead of more than " + std::to_string(longest_lead_days) +
                    " days; ingest newer currents");
  }
  return plan;
}

}  // namespace slackwater::calibration
