#include "api/pipeline/daily_job.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "api/pipeline/issued_blend.h"
#include "api/pipeline/job_summary.h"
#include "api/pipeline/known_currents.h"
#include "api/pipeline/parallel.h"
#include "api/pipeline/version.h"
#include "fields/base/error.h"
#include "ingest/cf/forecast_file.h"

namespace slackwater::api {
namespace {

using std::chrono::days;
using std::chrono::hours;

/// The column that speaks for the site when days are chosen: the first with currents.
const ColumnData* leading_column(const SiteData& data) {
  for (const ColumnData& column : data.columns) {
    if (!column.current.pieces.empty()) return &column;
  }
  return nullptr;
}

/// Days with any current, newest first, none after the issue time.
std::vector<UtcDay> candidate_days(const ColumnData& column, UtcTime issued) {
  std::set<UtcDay> found;
  for (const auto& piece : column.current.pieces) {
    for (const TimeCell& cell : piece.column.time) {
      const UtcDay day = day_of(cell.centre());
      if (UtcTime(day) + days(1) <= issued) found.insert(day);
    }
  }
  return {found.rbegin(), found.rend()};
}

/// The currents of a day as known at the issue time, and the dataset they are from.
std::pair<VectorColumn, std::string> currents_of(const ColumnData& column, UtcDay day,
                                                 UtcTime issued) {
  const UtcTime from(day);
  const UtcTime to = from + days(1);
  const auto dataset = fullest_dataset(column.current, from, to);
  if (!dataset) return {};
  ForecastPlan plan;
  plan.day = day;
  plan.issued = issued;
  plan.dataset = *dataset;
  return {slice(known_currents(column, plan).column, from, to), *dataset};
}

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

std::string capitalised(std::string text) {
  if (!text.empty()) text[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(text[0])));
  return text;
}

}  // namespace

bool holds_throughout(const VectorColumn& currents, UtcDay day) {
  std::vector<TimeCell> cells;
  for (std::size_t t = 0; t < currents.times(); ++t) {
    if (!belongs_to_day(currents.time[t], day)) continue;
    bool any = false;
    for (std::size_t k = 0; k < currents.levels() && !any; ++k) any = currents.has(t, k);
    if (any) cells.push_back(currents.time[t]);
  }
  if (cells.empty()) return false;
  const UtcTime from(day);
  const UtcTime to = from + days(1);
  // One daily mean (also a 25-hour mean cut at the day's ends) holds the whole day.
  if (cells.size() == 1) return cells[0].end - cells[0].start >= hours(20);
  std::vector<Duration> steps;
  for (std::size_t i = 1; i < cells.size(); ++i)
    steps.push_back(cells[i].centre() - cells[i - 1].centre());
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2),
                   steps.end());
  // Instruments that sample finer than hourly are held to what an hourly series is.
  const Duration usual = std::max<Duration>(steps[steps.size() / 2], hours(1));
  const auto too_wide = [&](Duration gap) { return 2 * gap > 5 * usual; };
  for (std::size_t i = 1; i < cells.size(); ++i) {
    if (too_wide(cells[i].centre() - cells[i - 1].centre())) return false;
  }
  return cells.front().start - from <= usual && to - cells.back().end <= usual;
}

std::optional<UtcDay> newest_whole_day(const SiteData& data, UtcTime issued) {
  const ColumnData* column = leading_column(data);
  if (column == nullptr) return std::nullopt;
  for (const UtcDay day : candidate_days(*column, issued)) {
    if (holds_throughout(currents_of(*column, day, issued).first, day)) return day;
  }
  return std::nullopt;
}

bool holds_day(const SiteData& data, UtcDay day, UtcTime issued) {
  const ColumnData* column = leading_column(data);
  return column != nullptr && holds_throughout(currents_of(*column, day, issued).first, day);
}

namespace {

/// Issues the blend that the rehearsed past has earned.
void blend_columns(const SiteData& data, const ForecastPlan& plan, const JobOptions& options,
                   DailyForecast& result) {
  const auto first = std::find_if(result.columns.begin(), result.columns.end(),
                                  [](const ColumnForecast& c) { return !c.forms.empty(); });
  if (first == result.columns.end()) return;
  const auto index = static_cast<std::size_t>(first - result.columns.begin());
  Rehearsals own(data);
  Rehearsals& rehearsals = options.rehearsals != nullptr ? *options.rehearsals : own;
  result.earned = rehearsals.earned(
      plan, available_candidates(first->column, data.columns[index], plan), options.threads);
  for_all(data.columns.size(), options.threads, [&](std::size_t i) {
    if (result.columns[i].forms.empty()) return;
    issue_blend(result.columns[i].column, data.columns[i], plan, *result.earned);
  });
}

}  // namespace

DailyForecast make_forecast(const SiteData& data, const JobOptions& options) {
  DailyForecast result;
  Snapshot& snapshot = result.snapshot;
  std::vector<std::string> troubles;  // each makes the forecast degraded

  const ColumnData* leading = leading_column(data);
  std::optional<UtcDay> usable;
  std::optional<UtcDay> wanted = options.day;
  if (leading != nullptr) {
    if (wanted && holds_throughout(currents_of(*leading, *wanted, options.issued).first, *wanted)) {
      usable = wanted;
    } else {
      for (const UtcDay day : candidate_days(*leading, options.issued)) {
        if (wanted && day > *wanted) continue;
        if (holds_throughout(currents_of(*leading, day, options.issued).first, day)) {
          usable = day;
          break;
        }
      }
    }
  }
  const UtcDay newest_possible = day_of(options.issued) - days(1);
  // Providers deliver a day late; more than that is late, and the forecast still has to reach as far.
  if (!wanted) wanted = std::max(usable.value_or(newest_possible), newest_possible - days(1));
  ForecastPlan plan;
  plan.day = usable.value_or(*wanted);
  plan.issued = options.issued;
  plan.wind = options.wind;
  plan.seed = options.seed;
  const UtcTime wanted_end = UtcTime(*wanted) + days(1);
  plan.stamps = hourly(plan.end_of_day(), wanted_end + options.horizon);
  if (usable) plan.dataset = currents_of(*leading, *usable, options.issued).second;
  result.dataset = plan.dataset;
  if (usable) plan.depth_m = wet_levels(data, plan.dataset);
  if (usable && *usable != *wanted) {
    troubles.push_back("currents of " + format_day(*wanted) +
                       " are missing or not whole, the last good day " + format_day(*usable) +
                       " is used");
  }
  if (!usable) troubles.push_back("no whole day of currents is stored: wind and waves alone");
  // A plan of more than some weeks of lead is no forecast.
  if (plan.stamps.size() > 24 * 40) {
    throw Error(ErrorKind::not_found, "the newest usable day of currents is " +
                                          format_day(plan.day) + ", more than 30 days before " +
                                          format_day(*wanted) + "; ingest newer currents");
  }

  result.columns.resize(data.columns.size());
  for_all(data.columns.size(), options.threads, [&](std::size_t i) {
    result.columns[i] = forecast_column(data.columns[i], data.site, plan);
    const std::vector<std::string> notes = notes_on_record(data.columns[i], plan);
    result.columns[i].notes.insert(result.columns[i].notes.begin(), notes.begin(), notes.end());
  });
  blend_columns(data, plan, options, result);

  std::set<std::int64_t> granules;
  std::set<std::string> attributions;
  std::size_t uncalibrated = 0;
  std::string first_problem;
  for (ColumnForecast& column : result.columns) {
    for (const Origin* origin : column.origins) {
      granules.insert(origin->granules.begin(), origin->granules.end());
      if (!origin->attribution.empty()) attributions.insert(origin->attribution);
    }
    if (usable && column.forms.empty()) {
      ++uncalibrated;
      if (first_problem.empty()) first_problem = column.calibration_problem;
    }
    snapshot.contains_stokes = snapshot.contains_stokes || column.contains_stokes;
    snapshot.columns.push_back(column.column);
  }
  if (uncalibrated == result.columns.size() && usable) {
    troubles.push_back("calibration failed: " + first_problem);
  } else if (uncalibrated > 0) {
    troubles.push_back(std::to_string(uncalibrated) + " of " +
                       std::to_string(result.columns.size()) +
                       " columns are not calibrated: " + first_problem);
  }
  const ForecastColumn& first = snapshot.columns.front();
  if (first.wind_m_s.empty()) {
    troubles.push_back("no wind is stored: the wind-driven part is left out");
  } else if (options.wind != WindPolicy::persist) {
    const auto persisted =
        std::count(first.wind_source.begin(), first.wind_source.end(), DataStatus::persisted);
    if (2 * persisted > static_cast<std::ptrdiff_t>(first.wind_source.size())) {
      troubles.push_back("wind is persisted for " + std::to_string(persisted) + " of " +
                         std::to_string(first.wind_source.size()) +
                         " hours: no wind forecast is stored");
    }
  }
  snapshot.site_id = data.site.id;
  snapshot.site_name = data.site.name;
  snapshot.day = plan.day;
  snapshot.issued = options.issued;
  snapshot.wind_policy = name_of(options.wind);
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.seed = plan.seed;
  const std::size_t values = plan.stamps.size() * plan.depth_m.size();
  for (const ForecastColumn& column : snapshot.columns) {
    if (values > 0)
      snapshot.members = std::max(snapshot.members, 1 + column.member_m_s.size() / values);
  }
  snapshot.degraded = !troubles.empty();
  for (const std::string& trouble : troubles) {
    snapshot.headline += (snapshot.headline.empty() ? "" : "; ") +
                         (snapshot.headline.empty() ? capitalised(trouble) : trouble);
  }
  if (snapshot.headline.empty()) {
    snapshot.headline = "Currents calibrated on " + format_day(plan.day) + ", forecast to " +
                        format_utc(plan.stamps.back());
  }
  snapshot.headline += ".";
  snapshot.attributions.assign(attributions.begin(), attributions.end());
  result.input_granules.assign(granules.begin(), granules.end());
  result.summary_json = job_summary(data, plan, options, result);
  snapshot.provenance_json = job_provenance(data, options, result);
  return result;
}

std::int64_t publish(store::Store& store, const DailyForecast& forecast,
                     const JobOptions& options) {
  return publish(store, std::span(&forecast, 1), options).front();
}

std::vector<std::int64_t> publish(store::Store& store, std::span<const DailyForecast> forecasts,
                                  const JobOptions& options) {
  std::vector<store::NewForecast> rows;
  for (const DailyForecast& forecast : forecasts) {
    const Snapshot& snapshot = forecast.snapshot;
    store::NewForecast row;
    row.content_file = store.staging_folder() / ("forecast-" + std::to_string(rows.size()) + ".nc");
    ingest::write_forecast(row.content_file, snapshot);
    row.row.site_id = snapshot.site_id;
    row.row.day = snapshot.day;
    row.row.issued = snapshot.issued;
    row.row.valid_from = snapshot.time.front();
    row.row.valid_to = snapshot.time.back();
    row.row.wind_policy = snapshot.wind_policy;
    row.row.origin = options.origin;
    row.row.degraded = snapshot.degraded;
    row.row.headline = snapshot.headline;
    row.row.summary_json = forecast.summary_json;
    row.row.code_version = code_version();
    row.row.input_granules = forecast.input_granules;
    rows.push_back(std::move(row));
  }
  return store.commit_forecasts(rows);
}

}  // namespace slackwater::api
