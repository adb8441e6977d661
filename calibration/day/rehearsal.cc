#include "calibration/day/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/day/known_currents.h"
#include "calibration/day/leading_day.h"
#include "calibration/day/methods.h"
#include "fields/base/parallel.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;
using std::chrono::hours;

/// The plan moved to another day, issued as late after it.
ForecastPlan moved_to(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan moved = plan;
  moved.day = day;
  const Duration later = plan.issued - plan.end_of_day();
  moved.issued = moved.end_of_day() + later;
  if (plan.best.issued) moved.best.issued = moved.issued;
  return moved;
}

/// The plan of a past day as it would have been run then, for one day of lead, with few members:
/// they are not looked at. Best wind and waves are those known when its truth is in: nothing of it
/// rests on who asks.
ForecastPlan plan_of(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan past = moved_to(plan, day);
  if (plan.best.known_by != UtcTime::max()) {
    past.best.known_by = past.end_of_day() + days(1) + (plan.best.known_by - plan.end_of_day());
  }
  past.spread.members = 8;
  past.stamps.clear();
  for (int h = 0; h <= 25; ++h) past.stamps.push_back(past.end_of_day() + hours(h));
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

/// The record's own next day, as known when that day has ended: what a rehearsed forecast is held
/// against, fused where the record is.
Chosen<Horizontal> day_after(const Chosen<Horizontal>& known, UtcTime end_of_day) {
  VectorColumn next = slice(known.column, end_of_day, end_of_day + days(1));
  // The instant at 24:00 of D belongs to D.
  if (!next.time.empty() && next.time.front().end <= end_of_day)
    next = slice(next, end_of_day + Duration(1), end_of_day + days(1));
  return {std::move(next), known.origin, known.stretches};
}

}  // namespace

std::vector<Method> candidate_methods() {
  std::vector<Method> methods;
  for (const Candidate& c : standard_candidates()) methods.push_back(c.method);
  return methods;
}

Rehearsals::Rehearsals(const SiteData& data, ColumnParts parts)
    : data_(data), parts_(std::move(parts)) {
  parts_.waves = [](auto&&...) { return HorizonSea{}; };
}

RehearsedDay Rehearsals::rehearse(const ForecastPlan& plan, UtcDay day) const {
  const std::vector<Method> candidates = candidate_methods();
  RehearsedDay result;
  const ForecastPlan past = plan_of(plan, day);
  const ForecastPlan next = moved_to(plan, day + days(1));
  if (!holds_day(data_, past.dataset, day, {past.issued, past.seen_by, {}})) return result;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const std::size_t i : columns_to_rehearse(data_, most_columns)) {
    const ColumnData& column = data_.columns[i];
    const Chosen<Horizontal> truth = day_after(known_currents(column, next), past.end_of_day());
    if (truth.empty()) continue;
    Snapshot snapshot;
    snapshot.day = day;
    snapshot.time = past.stamps;
    snapshot.depth_m = past.depth_m;
    ColumnForecast made = forecast_column(column, data_.site, past, parts_);
    // What cannot be fitted on a past day is no forecast of it; a bug is for the reader to know.
    for (const PartFailure& failed : made.failures) {
      if (loses_the_current(failed.part) && failed.failure.kind == ErrorKind::internal)
        result.failure = failed.failure;
    }
    snapshot.columns.push_back(std::move(made.column));
    const std::vector<MethodForecast> methods =
        current_methods(column, past, snapshot, 0, truth, made.known);
    const std::size_t size = truth.column.value.size();
    if (result.errors.empty()) result.errors.resize(candidates.size());
    const std::size_t before = result.sigma_m_s.size();
    for (std::size_t c = 0; c < candidates.size(); ++c)
      result.errors[c].resize(before + size, Horizontal(nan, nan));
    result.sigma_m_s.resize(before + size, nan);
    for (const MethodForecast& method : methods) {
      const auto found = std::find(candidates.begin(), candidates.end(), method.method);
      const auto c = static_cast<std::size_t>(found - candidates.begin());
      if (c == candidates.size()) continue;  // the oracle is no candidate
      for (std::size_t o = 0; o < size; ++o) {
        if (!has_value(truth.column.status[o]) || !method.made.has(o)) continue;
        result.errors[c][before + o] = method.made.value[o] - truth.column.value[o];
        if (!method.sigma_m_s.empty()) result.sigma_m_s[before + o] = method.sigma_m_s[o];
      }
    }
  }
  for (std::vector<Horizontal>& errors : result.errors) {
    const bool any = std::any_of(errors.begin(), errors.end(), [](Horizontal e) {
      return std::isfinite(e.real()) && std::isfinite(e.imag());
    });
    if (!any) errors.clear();
  }
  return result;
}

std::shared_ptr<const RehearsedDay> Rehearsals::day(const ForecastPlan& plan, UtcDay day) {
  const ForecastPlan past = plan_of(plan, day);
  const Key key{day,         past.wind,          past.dataset,
                past.issued, past.best.known_by, past.best.hindsight,
                past.seed,   past.depth_m,       past.seen_by};
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

Earned Rehearsals::earned(const ForecastPlan& plan, const std::vector<bool>& available,
                          int threads) {
  for_all(longest_days, threads,
          [&](std::size_t i) { (void)day(plan, plan.day - days(static_cast<int>(i) + 1)); });
  std::vector<Candidate> candidates = standard_candidates();
  for (std::size_t c = 0; c < candidates.size(); ++c) candidates[c].available = available[c];
  std::vector<PastPair> pairs;
  std::vector<std::shared_ptr<const RehearsedDay>> rehearsed;
  std::vector<double> age_days;
  Earned earned;
  for (int before = longest_days; before >= 1; --before) {
    auto past = day(plan, plan.day - days(before));
    if (past->failure) {
      ++earned.failed_days;
      if (!earned.first_failure) earned.first_failure = past->failure;
    }
    if (past->errors.empty() || past->errors.front().empty()) continue;
    age_days.push_back(before - 1);
    pairs.push_back(pair_of_errors(past->errors, age_days.back()));
    rehearsed.push_back(std::move(past));
  }
  earned.blend = blend_of(candidates, pairs);
  std::vector<PastSpread> spreads;
  for (std::size_t p = 0; p < rehearsed.size(); ++p) {
    const RehearsedDay& past = *rehearsed[p];
    PastSpread spread;
    spread.age_days = age_days[p];
    for (std::size_t o = 0; o < past.sigma_m_s.size(); ++o) {
      Horizontal error{};
      double weight = 0;
      for (std::size_t c = 0; c < past.errors.size(); ++c) {
        const double w = earned.blend.share[c].weight;
        if (w <= 0 || past.errors[c].empty() || !std::isfinite(past.errors[c][o].real())) continue;
        error += w * past.errors[c][o];
        weight += w;
      }
      if (weight <= 0) continue;
      spread.errors.add(error.real() / weight, past.sigma_m_s[o]);
      spread.errors.add(error.imag() / weight, past.sigma_m_s[o]);
    }
    spreads.push_back(spread);
  }
  earned.spread = earned_spread(spreads);
  return earned;
}

}  // namespace slackwater::calibration
