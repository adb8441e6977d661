#include "calibration/day/troubles.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <set>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::calibration {
namespace {

/// What was late or missing about the day's currents.
void judge_day(const DayChoice& choice, bool is_failed, std::vector<std::string>& troubles) {
  if (!choice.usable && !is_failed) {
    troubles.push_back("no whole day of currents is stored: only wind and waves are forecast");
  } else if (choice.usable && *choice.usable != choice.wanted) {
    troubles.push_back("currents of " + format_day(choice.wanted) +
                       " are missing or incomplete: the last good day, " +
                       format_day(*choice.usable) + ", is used");
  }
}

bool has_failed(const ColumnForecast& column, Part part) {
  return std::any_of(column.failures.begin(), column.failures.end(),
                     [&](const PartFailure& failed) { return failed.part == part; });
}

/// The product that the site names and nobody has stored.
void judge_named_product(const SiteData& data, std::vector<std::string>& troubles) {
  const auto& named = data.site.current_product;
  if (!named || !data.has_currents()) return;
  for (const ColumnData& column : data.columns) {
    for (const auto& piece : column.current.pieces)
      if (piece.origin->product_id == *named) return;
  }
  troubles.push_back("the site's file names currents of " + *named +
                     ", but none are stored: another product is used; ingest that product, or "
                     "correct `currents` in the site's file");
}

/// Which columns could not be calibrated; those that failed as a whole are named with the parts.
void judge_columns(const std::vector<ColumnForecast>& columns, std::vector<std::string>& troubles) {
  std::size_t uncalibrated = 0;
  std::string first_problem;
  for (const ColumnForecast& column : columns) {
    if (!column.forms.empty() || has_failed(column, Part::column)) continue;
    ++uncalibrated;
    if (first_problem.empty()) first_problem = column.calibration_problem;
  }
  if (uncalibrated > 0 && uncalibrated == columns.size()) {
    troubles.push_back("calibration failed: " + first_problem);
  } else if (uncalibrated > 0) {
    troubles.push_back(std::to_string(uncalibrated) + " of " + std::to_string(columns.size()) +
                       " columns are not calibrated: " + first_problem);
  }
}

/// Day D that nobody has analysed yet.
void judge_fit(const std::vector<ColumnForecast>& columns, const ForecastPlan& plan,
               std::vector<std::string>& troubles) {
  if (std::any_of(columns.begin(), columns.end(),
                  [](const ColumnForecast& column) { return column.fitted_to_a_forecast; }))
    troubles.push_back("the currents of " + format_day(plan.day) +
                       " are of a provider's forecast, not analysed: its errors are not known");
}

/// Whether the wind beyond D is there.
void judge_wind(const ColumnForecast& made, const ForecastPlan& plan,
                std::vector<std::string>& troubles) {
  const ForecastColumn& column = made.column;
  if (has_failed(made, Part::wind) || has_failed(made, Part::column)) return;  // said of the parts
  if (column.wind_m_s.empty()) {
    troubles.push_back("no wind is stored: the wind-driven current is left out");
    return;
  }
  if (plan.wind == WindPolicy::persist) return;
  for (const WindGap& gap : made.wind_gaps) {
    troubles.push_back("no wind is known from " + format_utc(gap.from) + " to " +
                       format_utc(gap.to) + ": the last known wind is used there");
  }
  const auto persisted =
      std::count(column.wind_source.begin(), column.wind_source.end(), DataStatus::persisted);
  if (2 * persisted > static_cast<std::ptrdiff_t>(column.wind_source.size())) {
    troubles.push_back("the last known wind is used for " + std::to_string(persisted) + " of " +
                       std::to_string(column.wind_source.size()) +
                       " hours: no wind forecast that was known at " + format_utc(plan.issued) +
                       " is stored");
  }
}

/// Which instruments lie, each once: it is the same at every column.
void judge_instruments(const std::vector<ColumnForecast>& columns,
                       std::vector<std::string>& troubles) {
  std::set<std::string> named;
  for (const ColumnForecast& column : columns) {
    for (const MooredInstrumentTrouble& trouble : column.remarks.troubles)
      if (named.insert(trouble.station).second) troubles.push_back(trouble.clause);
  }
}

/// Which parts had to be left out, each once.
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
    troubles.push_back("the rehearsal of " + std::to_string(result.earned->failed_days) +
                       (result.earned->failed_days == 1 ? " past day" : " past days") +
                       " failed; the blend uses the others: " + result.earned->first_failure->why);
  }
}

std::string plain_headline(const ForecastPlan& plan, const std::vector<std::string>& troubles) {
  if (troubles.empty()) {
    return "Currents calibrated on " + format_day(plan.day) + ", forecast to " +
           format_utc(plan.stamps.back()) + ".";
  }
  std::string headline = troubles.front();
  headline[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(headline[0])));
  for (std::size_t i = 1; i < troubles.size(); ++i) headline += "; " + troubles[i];
  return headline + ".";
}

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

std::vector<std::string> troubles_of(const SiteData& data, const DayChoice& choice,
                                     const std::optional<AveragedCurrents>& averaged,
                                     const DailyForecast& made) {
  std::vector<std::string> troubles;
  const bool is_choice_failed =
      std::any_of(made.failures.begin(), made.failures.end(),
                  [](const PartFailure& failed) { return failed.part == Part::day; });
  judge_day(choice, is_choice_failed, troubles);
  judge_named_product(data, troubles);
  if (choice.usable) judge_columns(made.columns, troubles);
  judge_fit(made.columns, made.plan, troubles);
  judge_instruments(made.columns, troubles);
  if (averaged) troubles.push_back(sentence_of(*averaged));
  if (made.stand_in) troubles.push_back(text_of(*made.stand_in));
  judge_wind(made.columns.front(), made.plan, troubles);
  if (made.computed_waves && is_degradation(*made.computed_waves, made.plan.wind))
    troubles.push_back(text_of(*made.computed_waves));
  if (!data.damage.empty()) troubles.push_back(data.damage);
  judge_parts(made, troubles);
  return troubles;
}

std::string headline_of(const ForecastPlan& plan, const std::vector<std::string>& troubles,
                        const Snapshot& made) {
  std::string headline = plain_headline(plan, troubles);
  if (made.simulated_wind) {
    headline += " Driven by a simulated wind forecast: no wind forecast published by " +
                format_utc(plan.issued) + " is stored.";
  } else if (made.hindsight) {
    headline += " Made in hindsight: wind or waves were used that were not known at " +
                format_utc(plan.issued) + ".";
  }
  return headline;
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
