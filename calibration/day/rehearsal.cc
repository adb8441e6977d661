#include "calibration/day/rehearsal.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/column/methods.h"
#include "calibration/day/given/known_currents.h"
#include "calibration/day/leading_day.h"
#include "calibration/day/past_plan.h"
#include "fields/base/parallel.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;

/// The plan of a past day with the editions of its currents that stood in the store when it would
/// have been issued. Those of now stand for them where the day was not whole in the store by then:
/// an archive that was read later, a file that came late. Runs of wind and of currents go by
/// publication alone: one that came minutes later than today's is no other run.
ForecastPlan with_editions_of_then(ForecastPlan past, const SiteData& data) {
  if (past.seen_by == UtcTime::max()) return past;  // a hindcast looks at all of an archive
  const UtcTime then = std::min(past.issued, past.seen_by);
  UtcTime begins_then = UtcTime::max();
  UtcTime begins_now = UtcTime::max();
  for (const ColumnData& column : data.columns) {
    for (const PieceColumn<Horizontal>& piece : column.current.pieces) {
      if (piece.column.time.empty() || piece.origin->dataset != past.dataset) continue;
      const UtcTime first = piece.column.time.front().start;
      begins_now = std::min(begins_now, first);
      if (piece.origin->received && *piece.origin->received <= then)
        begins_then = std::min(begins_then, first);
    }
  }
  // A record that was lengthened backwards since is no poorer for today's forecast.
  const bool is_as_long = begins_then != UtcTime::max() && begins_then <= begins_now;
  if (is_as_long && holds_day(data, past.dataset, past.day, {past.issued, then, {}}))
    past.editions_by = then;
  return past;
}

/// Evenly spread over all columns that have currents.
std::vector<std::size_t> columns_to_rehearse(const SiteData& data, std::size_t most) {
  std::vector<std::size_t> with_currents;
  for (std::size_t i = 0; i < data.columns.size(); ++i) {
    if (!data.columns[i].current.pieces.empty()) with_currents.push_back(i);
  }
  if (with_currents.size() <= most) return with_currents;
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < most; ++i)
    chosen.push_back(with_currents[(2 * i + 1) * with_currents.size() / (2 * most)]);
  return chosen;
}

/// The record's own days after one, each as known when it had ended: what a rehearsed forecast is
/// held against, fused where the record is. Days on other levels than the first are left out.
Chosen<Horizontal> days_after(const ColumnData& column, const ForecastPlan& plan,
                              const ForecastPlan& past) {
  Chosen<Horizontal> after;
  for (int later = 1; later <= lead_days_of(plan); ++later) {
    const Chosen<Horizontal> known =
        known_currents(column, moved_to(plan, past.day + days(later))).record;
    const UtcTime from = past.end_of_day() + days(later - 1);
    // The instant at 24:00 of a day belongs to it.
    VectorColumn next = slice(known.column, from, from + days(1));
    if (!next.time.empty() && next.time.front().end <= from)
      next = slice(next, from + Duration(1), from + days(1));
    if (next.time.empty() || is_of_a_forecast(known, next)) continue;
    std::vector<double> noise(next.value.size());
    if (!known.noise_m_s.empty()) {  // the record's last values are those of the day
      std::copy(known.noise_m_s.end() - static_cast<std::ptrdiff_t>(noise.size()),
                known.noise_m_s.end(), noise.begin());
    }
    if (after.empty()) {
      after.column = std::move(next);
      after.origin = known.origin;
      after.noise_m_s = std::move(noise);
    } else if (next.levels_m == after.column.levels_m) {
      append(after.column, next);
      after.noise_m_s.insert(after.noise_m_s.end(), noise.begin(), noise.end());
    }
  }
  return after;
}

}  // namespace

RehearsedDays::RehearsedDays(const SiteData& data, ColumnParts parts)
    : data_(data), parts_(std::move(parts)) {
  parts_.waves = [](auto&&...) { return HorizonSea{}; };
}

RehearsedDay RehearsedDays::rehearse(const ForecastPlan& plan, UtcDay day) const {
  RehearsedDay result;
  const ForecastPlan past = with_editions_of_then(past_plan(plan, day), data_);
  result.lead.resize(static_cast<std::size_t>(lead_days_of(plan)));
  if (!holds_day(data_, past.dataset, day, {past.issued, past.seen_by, {}})) return result;
  for (const std::size_t i : columns_to_rehearse(data_, most_columns)) {
    const ColumnData& column = data_.columns[i];
    const Chosen<Horizontal> truth = days_after(column, plan, past);
    if (truth.empty()) continue;
    Snapshot snapshot;
    snapshot.day = day;
    snapshot.time = past.stamps;
    snapshot.depth_m = past.depth_m;
    ColumnForecast made = forecast_column(column, data_.site, past, parts_);
    result.simulated_wind = result.simulated_wind || made.simulated_wind;
    // What cannot be fitted on a past day is no forecast of it; a bug is for the reader to know.
    for (const PartFailure& failed : made.failures) {
      if (loses_the_current(failed.part) && failed.failure.kind == ErrorKind::internal)
        result.failure = failed.failure;
    }
    snapshot.columns.push_back(std::move(made.column));
    add_errors(current_methods(column, past, snapshot, 0, truth, made.known.currents,
                               made.known.provider, &made.known.tide),
               truth, past.end_of_day(), result);
  }
  for (RehearsedLead& lead : result.lead) clear_absent(lead);
  return result;
}

std::shared_ptr<const RehearsedDay> RehearsedDays::day(const ForecastPlan& plan, UtcDay day) {
  const ForecastPlan past = past_plan(plan, day);
  const Key key{day,
                past.wind,
                past.dataset,
                past.issued,
                past.best.known_by,
                past.best.hindsight,
                past.seed,
                past.depth_m,
                past.seen_by,
                past.stamps.size(),
                past.best.simulated_seed ? past.best.analysed_until : UtcTime::min()};
  {
    const std::lock_guard lock(mutex_);
    const auto found = done_.find(key);
    if (found != done_.end()) return found->second;
  }
  RehearsedDay made;
  if (auto failure = attempt([&] { made = rehearse(plan, day); }))
    made.failure = std::move(failure);
  auto kept = std::make_shared<const RehearsedDay>(std::move(made));
  const std::lock_guard lock(mutex_);
  return done_.emplace(key, std::move(kept)).first->second;
}

Earned RehearsedDays::earned(const ForecastPlan& asked, const std::vector<bool>& available,
                             int threads) {
  const ForecastPlan plan = with_past_runs(asked, data_, parts_);
  for_all(longest_days, threads,
          [&](std::size_t i) { (void)day(plan, plan.day - days(static_cast<int>(i) + 1)); });
  std::vector<Candidate> candidates = standard_candidates();
  for (std::size_t c = 0; c < candidates.size(); ++c) candidates[c].available = available[c];
  std::vector<std::vector<PastLead>> past(static_cast<std::size_t>(lead_days_of(plan)));
  std::size_t failed_days = 0;
  std::optional<Failure> first_failure;
  for (int before = longest_days; before >= 1; --before) {
    const auto rehearsed = day(plan, plan.day - days(before));
    if (rehearsed->failure) {
      ++failed_days;
      if (!first_failure) first_failure = rehearsed->failure;
    }
    // Of a day's leads those have a truth that ends by D.
    const std::size_t ended = std::min(static_cast<std::size_t>(before), rehearsed->lead.size());
    for (std::size_t lead = 0; lead < ended; ++lead) {
      const RehearsedLead& of_day = rehearsed->lead[lead];
      if (of_day.errors.empty() || of_day.errors.front().empty()) continue;
      past[lead].push_back(
          {rehearsed, lead, static_cast<double>(before - 1) - static_cast<double>(lead)});
    }
  }
  Earned earned = earned_from(past, candidates);
  earned.failed_days = failed_days;
  earned.first_failure = std::move(first_failure);
  return earned;
}

}  // namespace slackwater::calibration
