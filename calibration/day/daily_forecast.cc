#include "calibration/day/daily_forecast.h"

#include <algorithm>
#include <map>
#include <set>

#include "calibration/day/bed_note.h"
#include "calibration/day/day_choice.h"
#include "calibration/day/driving_ensemble.h"
#include "calibration/day/issued_blend.h"
#include "calibration/day/known_currents.h"
#include "calibration/day/troubles.h"
#include "calibration/day/unresolved_tide.h"
#include "fields/base/averaging.h"
#include "fields/base/error.h"
#include "fields/base/parallel.h"
#include "fields/base/text.h"
#include "fields/service/bed_rule.h"

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

namespace {

constexpr const char* hindsight_note =
    "made in hindsight: wind or waves were used that were not known at the issue time";

/// Every column by itself: one that fails does not stop the others.
void forecast_columns(const SiteData& data, const ForecastOptions& options, DailyForecast& result) {
  const ForecastPlan& plan = result.plan;
  result.columns.resize(data.columns.size());
  for_all(data.columns.size(), options.threads, [&](std::size_t i) {
    ColumnForecast& made = result.columns[i];
    made = empty_forecast(data.columns[i], plan);
    std::vector<PartFailure> failures;
    attempt_part(Part::column, failures, [&] {
      made = options.parts.column(data.columns[i], data.site, plan, options.parts.of_column);
    });
    if (!failures.empty()) {
      made.calibration_problem = failures.front().failure.why;
      made.failures.push_back(std::move(failures.front()));
    }
    std::vector<std::string> notes;
    const auto tell = [&] {
      notes = notes_on_record(data.columns[i], plan);
      made.instrument_troubles = troubles_on_record(data.columns[i], plan);
    };
    if (const auto failure = attempt(tell)) notes = {"no notes on the record: " + failure->why};
    if (auto note = note_on_bed(data.columns[i], plan.dataset)) notes.push_back(std::move(*note));
    const std::string& of_waves = data.columns[i].wave_period_note;
    if (!of_waves.empty()) notes.push_back(of_waves);
    made.notes.insert(made.notes.begin(), notes.begin(), notes.end());
    if (made.hindsight) made.notes.emplace_back(hindsight_note);
  });
}

/// What means over hours have earned was earned against means: baselines made of them are no
/// instants, and errors of means say nothing of a band too wide for hours.
void keep_to_our_own(Earned& earned) {
  for (CandidateShare& share : earned.blend.share)
    share.weight = share.method == Method::forecast ? 1 : 0;
  earned.blend.earned = false;
  earned.blend.fell_back_to.reset();
  earned.blend.provenance = "Our own alone: the currents are means, and so are the baselines.";
  earned.spread.scale = std::max(1.0, earned.spread.scale);
}

/// Issues the blend that the rehearsed past has earned; where that fails our own forecast stands.
void blend_columns(const SiteData& data, const ForecastOptions& options, const DayChoice& choice,
                   DailyForecast& result) {
  const ForecastPlan& plan = result.plan;
  const auto first = std::find_if(result.columns.begin(), result.columns.end(),
                                  [](const ColumnForecast& c) { return !c.forms.empty(); });
  if (first == result.columns.end()) return;
  const auto index = static_cast<std::size_t>(first - result.columns.begin());
  Rehearsals own(data, options.parts.of_column);
  Rehearsals& rehearsals = options.rehearsals != nullptr ? *options.rehearsals : own;
  const bool is_rehearsed = attempt_part(Part::rehearsal, result.failures, [&] {
    result.earned = options.parts.rehearsal(
        rehearsals, plan,
        available_candidates(first->column, data.columns[index], first->known, plan),
        options.threads);
  });
  if (!is_rehearsed) return;
  if (hides_the_tide(choice.averaging)) keep_to_our_own(*result.earned);
  for_all(data.columns.size(), options.threads, [&](std::size_t i) {
    ColumnForecast& made = result.columns[i];
    if (made.forms.empty()) return;
    attempt_part(Part::blend, made.failures, [&] {
      ForecastColumn blended = made.column;
      options.parts.blend(blended, data.columns[i], made.known, plan, *result.earned);
      made.column = std::move(blended);
    });
  });
}

/// Means over hours are no instants: their bands are widened by the tide that they leave out. Of
/// several columns the widest speaks; one whose tide nobody knows speaks for all.
std::optional<AveragedCurrents> widen_columns(const SiteData& data, const ForecastOptions& options,
                                              const DayChoice& choice, DailyForecast& result) {
  if (!hides_the_tide(choice.averaging)) return std::nullopt;
  std::vector<std::optional<AveragedCurrents>> found(result.columns.size());
  for_all(data.columns.size(), options.threads, [&](std::size_t i) {
    if (result.columns[i].forms.empty()) return;
    ColumnForecast& column = result.columns[i];
    found[i].emplace().averaging = choice.averaging;
    attempt_part(Part::unresolved_tide, column.failures, [&] {
      ForecastColumn widened = column.column;
      const auto tide =
          options.parts.unresolved_tide(widened, data.columns[i], column.known.column, result.plan);
      found[i] = tide ? std::optional(tide->averaged) : std::nullopt;
      if (!tide) return;
      column.column = std::move(widened);
      column.origins.insert(column.origins.end(), tide->origins.begin(), tide->origins.end());
    });
  });
  std::optional<AveragedCurrents> widest;
  for (const std::optional<AveragedCurrents>& column : found) {
    if (!column) continue;
    const bool is_unknown = !column->unresolved_tide_m_s;
    const bool is_wider =
        widest && widest->unresolved_tide_m_s &&
        (is_unknown || *column->unresolved_tide_m_s > *widest->unresolved_tide_m_s);
    if (!widest || is_wider) widest = column;
  }
  return widest;
}

/// Where another product stands in for the leading one, the bands are widened by what the two are
/// known to differ.
void widen_stand_in(const SiteData& data, const ForecastOptions& options, DailyForecast& result) {
  if (result.plan.stands_in_for.empty()) return;
  for (std::size_t i = 0; i < result.columns.size(); ++i) {
    ColumnForecast& column = result.columns[i];
    if (column.forms.empty()) continue;
    attempt_part(Part::stand_in, column.failures, [&] {
      ForecastColumn widened = column.column;
      auto found = options.parts.stand_in(widened, data.columns[i], result.plan);
      column.column = std::move(widened);
      if (!result.stand_in) result.stand_in = std::move(found);
    });
  }
}

/// Of the waves that no product gave, at the first column that has any.
std::optional<ComputedWaves> waves_of(const SiteData& data, const ForecastOptions& options,
                                      const DailyForecast& result) {
  for (std::size_t i = 0; i < result.columns.size(); ++i) {
    if (result.columns[i].column.sea.empty()) continue;
    return computed_waves(result.columns[i], data.columns[i], data.site, result.plan,
                          options.parts.of_column);
  }
  return std::nullopt;
}

/// The columns and what they share, as one forecast.
Snapshot snapshot_of(const SiteData& data, const ForecastPlan& plan,
                     const std::vector<ColumnForecast>& columns) {
  Snapshot snapshot;
  snapshot.site_id = data.site.id;
  snapshot.site_name = data.site.name;
  snapshot.day = plan.day;
  snapshot.issued = plan.issued;
  snapshot.wind_policy = plan.wind;
  snapshot.time = plan.stamps;
  snapshot.depth_m = plan.depth_m;
  snapshot.seed = plan.seed;
  std::set<std::string> attributions;
  std::set<std::string> ensembles;
  const std::size_t values = plan.stamps.size() * plan.depth_m.size();
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins) {
      if (!origin->attribution.empty()) attributions.insert(origin->attribution);
    }
    snapshot.contains_stokes = snapshot.contains_stokes || column.contains_stokes;
    snapshot.hindsight = snapshot.hindsight || column.hindsight;
    if (column.wind_ensemble) ensembles.insert(text_of(*column.wind_ensemble));
    snapshot.columns.push_back(column.column);
    if (values > 0)
      snapshot.members = std::max(snapshot.members, 1 + column.column.member_m_s.size() / values);
  }
  snapshot.attributions.assign(attributions.begin(), attributions.end());
  snapshot.wind_ensemble = joined(ensembles, "; ");
  return snapshot;
}

Provenance provenance_of(const SiteData& data, const ForecastOptions& options,
                         const std::vector<ColumnForecast>& columns) {
  Provenance provenance;
  provenance.site = data.site.id;
  provenance.issued = options.issued;
  provenance.code_version = options.code_version;
  std::map<std::string, std::set<std::string>> products;
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins)
      products[origin->product_id].insert(origin->sources.begin(), origin->sources.end());
  }
  for (const auto& [product, files] : products)
    provenance.inputs.push_back({product, {files.begin(), files.end()}});
  const Calibration* const fitted = columns.empty() ? nullptr : columns.front().calibration();
  if (fitted == nullptr) return provenance;
  CalibrationSummary& summary = provenance.calibration.emplace();
  summary.form = name_of(fitted->form);
  summary.rms_m_s = fitted->rms_m_s;
  summary.termination = fitted->termination;
  for (const Parameter& parameter : fitted->parameters)
    summary.parameters[parameter.name] = parameter.value;
  return provenance;
}

std::vector<std::int64_t> granules_of(const std::vector<ColumnForecast>& columns) {
  std::set<std::int64_t> granules;
  for (const ColumnForecast& column : columns) {
    for (const Origin* origin : column.origins)
      granules.insert(origin->granules.begin(), origin->granules.end());
  }
  return {granules.begin(), granules.end()};
}

}  // namespace

DailyForecast make_forecast(const SiteData& data, const ForecastOptions& options) {
  DailyForecast result;
  const DayChoice choice = choose_day(data, options, result.failures);
  result.plan = plan_of(data, options, choice);
  forecast_columns(data, options, result);
  blend_columns(data, options, choice, result);
  const std::optional<AveragedCurrents> averaged = widen_columns(data, options, choice, result);
  widen_stand_in(data, options, result);
  for (ColumnForecast& column : result.columns) {
    column.known = {};
    keep_to_bed(column.column, result.plan.depth_m);
  }
  result.computed_waves = waves_of(data, options, result);
  const std::vector<std::string> troubles = troubles_of(data, choice, averaged, result);
  expect_any_value(result, troubles);
  result.snapshot = snapshot_of(data, result.plan, result.columns);
  result.snapshot.degraded = !troubles.empty();
  result.snapshot.averaged = averaged;
  result.snapshot.headline = headline_of(result.plan, troubles, result.snapshot.hindsight);
  result.snapshot.provenance = provenance_of(data, options, result.columns);
  result.input_granules = granules_of(result.columns);
  return result;
}

}  // namespace slackwater::calibration
