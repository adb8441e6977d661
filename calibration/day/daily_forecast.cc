#include "calibration/day/daily_forecast.h"

#include <algorithm>

#include "calibration/day/column/unresolved_tide.h"
#include "calibration/day/day_choice.h"
#include "calibration/day/given/bed_note.h"
#include "calibration/day/issued_blend.h"
#include "calibration/day/issued_snapshot.h"
#include "calibration/day/past_plan.h"
#include "calibration/day/troubles.h"
#include "calibration/day/widen.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/parallel.h"
#include "fields/service/bed_rule.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;

constexpr const char* hindsight_note =
    "made in hindsight: wind or waves were used that were not known at the issue time";

std::string simulated_note(const ForecastPlan& plan) {
  return "the wind after D is simulated: no wind run published by the issue time is stored, so the "
         "later analysis with a random forecast error is used (seed " +
         std::to_string(plan.best.simulated_seed.value_or(0)) + ")";
}

/// What an operator should know of the column's inputs, before what the forecast has to say.
void tell_of_inputs(const ColumnData& data, const ForecastPlan& plan, ColumnForecast& made) {
  std::vector<std::string> notes = made.remarks.notes;
  if (auto note = note_on_bed(data, plan.dataset)) notes.push_back(std::move(*note));
  if (!data.wave_period_note.empty()) notes.push_back(data.wave_period_note);
  made.notes.insert(made.notes.begin(), notes.begin(), notes.end());
  if (made.simulated_wind) made.notes.push_back(simulated_note(plan));
}

/// Names the provider's runs among what the forecast rests on.
void add_provider_origins(ColumnForecast& made) {
  const std::vector<const Origin*>& origins = made.known.provider.origins;
  made.origins.insert(made.origins.end(), origins.begin(), origins.end());
  for (const Origin* origin : origins)
    made.contains_stokes = made.contains_stokes || origin->contains_stokes;
}

/// Every column by itself: one that fails does not stop the others.
void forecast_columns(const SiteData& data, const ForecastOptions& options, DailyForecast& result) {
  const ForecastPlan& plan = result.plan;
  result.columns.resize(data.columns.size());
  for_all(result.columns.size(), options.threads, [&](std::size_t i) {
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
    const auto failure = attempt([&] { tell_of_inputs(data.columns[i], plan, made); });
    if (failure) made.notes.push_back("the inputs could not be checked: " + failure->why);
    if (made.hindsight) made.notes.emplace_back(hindsight_note);
  });
}

/// What means over hours have earned was earned against means: baselines made of them are no
/// instants, and errors of means say nothing of a band too wide for hours.
void keep_to_our_own(Earned& earned) {
  earned.later.clear();
  for (CandidateShare& share : earned.blend.share)
    share.weight = share.method == Method::forecast ? 1 : 0;
  earned.blend.earned = false;
  earned.blend.fell_back_to.reset();
  earned.blend.provenance =
      "Our own forecast only, without a blend: the currents are means, and so are the baselines.";
  earned.spread.scale = std::max(1.0, earned.spread.scale);
  for (LaterSpread& later : earned.spread.later) later.scale = std::max(1.0, later.scale);
}

/// Issues the blend that the rehearsed past has earned; where that fails our own forecast stands.
void blend_columns(const SiteData& data, const ForecastOptions& options, const DayChoice& choice,
                   DailyForecast& result) {
  const ForecastPlan& plan = result.plan;
  const auto first = std::find_if(result.columns.begin(), result.columns.end(),
                                  [](const ColumnForecast& c) { return !c.forms.empty(); });
  if (first == result.columns.end()) return;
  const auto index = static_cast<std::size_t>(first - result.columns.begin());
  RehearsedDays own(data, options.parts.of_column);
  RehearsedDays& rehearsals = options.rehearsals != nullptr ? *options.rehearsals : own;
  const bool is_rehearsed = attempt_part(Part::rehearsal, result.failures, [&] {
    result.earned = options.parts.rehearsal(
        rehearsals, plan,
        available_candidates(first->column, data.columns[index], first->known, plan),
        options.threads);
  });
  if (!is_rehearsed) return;
  if (hides_the_tide(choice.averaging)) keep_to_our_own(*result.earned);
  for_all(result.columns.size(), options.threads, [&](std::size_t i) {
    ColumnForecast& made = result.columns[i];
    if (made.forms.empty()) return;
    attempt_part(Part::blend, made.failures, [&] {
      ForecastColumn blended = made.column;
      options.parts.blend(blended, data.columns[i], made.known, plan, *result.earned);
      made.column = std::move(blended);
      if (uses_provider(*result.earned) && made.known.provider.reaches_beyond(plan.end_of_day()))
        add_provider_origins(made);
    });
  });
}

/// Takes out of the wave heights what those of past days were off, at every column what was seen at
/// the first that knows its waves.
void correct_heights(const SiteData& data, const ForecastOptions& options, DailyForecast& result) {
  const auto first = std::find_if(
      data.columns.begin(), data.columns.end(),
      [](const ColumnData& column) { return !column.significant_height.pieces.empty(); });
  if (first == data.columns.end()) return;
  attempt_part(Part::wave_errors, result.failures, [&] {
    const EarnedHeights earned = options.parts.heights(
        *first, data.site, with_past_runs(result.plan, data, options.parts.of_column),
        options.parts.of_column, options.threads);
    for (std::size_t i = 0; i < result.columns.size(); ++i) {
      ColumnForecast& made = result.columns[i];
      if (made.column.sea.empty()) continue;
      const double usual_m = usual_height_m(data.columns[i], result.plan);
      std::string note = note_on(earned, usual_m, made.column);
      if (!note.empty()) made.notes.push_back(std::move(note));
      apply(earned, result.plan, usual_m, made.column);
    }
  });
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

}  // namespace

DailyForecast make_forecast(const SiteData& data, const ForecastOptions& options) {
  DailyForecast result;
  const DayChoice choice = choose_day(data, options, result.failures);
  result.plan = plan_of(data, options, choice);
  forecast_columns(data, options, result);
  correct_heights(data, options, result);
  blend_columns(data, options, choice, result);
  const std::optional<AveragedCurrents> averaged = widen_means(data, options, choice, result);
  widen_stand_in(data, options, choice, result);
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
  result.snapshot.headline = headline_of(result.plan, troubles, result.snapshot);
  result.snapshot.provenance = provenance_of(data, options, result.columns);
  result.input_granules = granules_of(result.columns);
  return result;
}

}  // namespace slackwater::calibration
