#include "calibration/day/rehearsal.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/day/known_currents.h"
#include "calibration/day/leading_day.h"
#include "calibration/day/methods.h"
#include "calibration/day/simulated_run.h"
#include "fields/base/parallel.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::days;
using std::chrono::hours;

/// The plan moved to another day, issued as late after it, and knowing no more; editions of values
/// are those of now.
ForecastPlan moved_to(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan moved = plan;
  moved.day = day;
  const Duration later = plan.issued - plan.end_of_day();
  moved.issued = moved.end_of_day() + later;
  if (plan.best.issued) moved.best.issued = moved.issued;
  if (plan.best.known_by != UtcTime::max())
    moved.best.known_by = moved.end_of_day() + (plan.best.known_by - plan.end_of_day());
  return moved;
}

/// Days of lead that are rehearsed.
int lead_days_of(const ForecastPlan& plan) {
  if (plan.stamps.empty()) return 1;
  const double reach_h = hours_between(plan.end_of_day(), plan.stamps.back());
  return std::clamp(static_cast<int>(std::ceil(reach_h / 24.0 - 1e-9)), 1,
                    Rehearsals::longest_lead_days);
}

/// The plan of a past day as it would have been run then, without members: they are not looked at,
/// and sigma is the same.
ForecastPlan plan_of(const ForecastPlan& plan, UtcDay day) {
  ForecastPlan past = moved_to(plan, day);
  past.spread.members = 0;
  past.stamps.clear();
  for (int h = 0; h <= 24 * lead_days_of(plan) + 1; ++h)
    past.stamps.push_back(past.end_of_day() + hours(h));
  return past;
}

/// The plan with runs of the wind to be simulated for past days, where one is known for the days to
/// come. What was analysed later stands for them under hindsight, and nothing where wind persists.
ForecastPlan with_past_runs(const ForecastPlan& plan, const SiteData& data,
                            const ColumnParts& parts) {
  ForecastPlan with = plan;
  if (plan.best.hindsight || plan.wind == WindPolicy::persist || data.columns.empty()) return with;
  // Where the wind fails, it does so for the forecast itself, which says so.
  const auto failure = attempt([&] {
    const HorizonWind now =
        parts.wind(data.columns.front().wind, plan.wind, plan.end_of_day(), plan.stamps, plan.best);
    if (!reaches_beyond(now, plan.stamps, plan.end_of_day())) return;
    with.best.simulated_seed = plan.seed;
    with.best.analysed_until = plan.issued;
  });
  if (failure) with.best.simulated_seed.reset();
  return with;
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
    const Chosen<Horizontal> known = known_currents(column, moved_to(plan, past.day + days(later)));
    const UtcTime from = past.end_of_day() + days(later - 1);
    // The instant at 24:00 of a day belongs to it.
    VectorColumn next = slice(known.column, from, from + days(1));
    if (!next.time.empty() && next.time.front().end <= from)
      next = slice(next, from + Duration(1), from + days(1));
    if (next.time.empty()) continue;
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

/// Puts what the methods said of the truth beside it, each value with the day of lead it is of.
void add_errors(const std::vector<MethodForecast>& methods, const Chosen<Horizontal>& against,
                UtcTime end_of_day, RehearsedDay& result) {
  const VectorColumn& truth = against.column;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Method> candidates = candidate_methods();
  for (std::size_t t = 0; t < truth.times(); ++t) {
    const double lead_h = hours_between(end_of_day, truth.time[t].centre());
    const auto day = static_cast<std::size_t>(std::max(0.0, std::ceil(lead_h / 24.0) - 1));
    if (day >= result.lead.size()) continue;
    RehearsedLead& lead = result.lead[day];
    if (lead.errors.empty()) lead.errors.resize(candidates.size());
    for (std::size_t k = 0; k < truth.levels(); ++k) {
      const std::size_t o = truth.offset(t, k);
      for (std::vector<Horizontal>& errors : lead.errors) errors.emplace_back(nan, nan);
      lead.sigma_m_s.push_back(nan);
      lead.merged_sigma_m_s.push_back(nan);
      lead.noise_m_s.push_back(against.noise_m_s[o]);
      if (!has_value(truth.status[o])) continue;
      for (const MethodForecast& method : methods) {
        const auto found = std::find(candidates.begin(), candidates.end(), method.method);
        if (found == candidates.end() || !method.made.has(o)) continue;  // the oracle is none
        const auto c = static_cast<std::size_t>(found - candidates.begin());
        lead.errors[c].back() = method.made.value[o] - truth.value[o];
        if (method.method == Method::forecast) lead.sigma_m_s.back() = method.sigma_m_s[o];
        if (method.method == Method::merged) lead.merged_sigma_m_s.back() = method.sigma_m_s[o];
      }
    }
  }
}

/// A candidate without any value is absent.
void clear_absent(RehearsedLead& lead) {
  for (std::vector<Horizontal>& errors : lead.errors) {
    const bool any = std::any_of(errors.begin(), errors.end(), [](Horizontal e) {
      return std::isfinite(e.real()) && std::isfinite(e.imag());
    });
    if (!any) errors.clear();
  }
}

/// A rehearsed day as evidence on one day of lead.
struct PastLead {
  std::shared_ptr<const RehearsedDay> day;
  const RehearsedLead* lead = nullptr;
  double age_days = 0;
};

Blend blend_of_leads(const std::vector<PastLead>& past, const std::vector<Candidate>& candidates) {
  std::vector<PastPair> pairs;
  for (const PastLead& one : past) pairs.push_back(pair_of_errors(one.lead->errors, one.age_days));
  return blend_of(candidates, pairs);
}

/// The blend's errors on one day of lead against its own spread.
NormalisedErrors normalised(const RehearsedLead& lead, const Blend& blend) {
  std::vector<double> weights;
  for (const CandidateShare& share : blend.share) weights.push_back(share.weight);
  NormalisedErrors errors;
  for (std::size_t o = 0; o < lead.sigma_m_s.size(); ++o) {
    Horizontal error{};
    double weight = 0;
    for (std::size_t c = 0; c < lead.errors.size(); ++c) {
      if (weights[c] <= 0 || lead.errors[c].empty() || !std::isfinite(lead.errors[c][o].real()))
        continue;
      error += weights[c] * lead.errors[c][o];
      weight += weights[c];
    }
    if (weight <= 0) continue;
    const double blended =
        sigma_of_blend(blend, weights, lead.sigma_m_s[o], lead.merged_sigma_m_s[o]);
    const double sigma = std::hypot(blended, lead.noise_m_s[o]);
    errors.add(error.real() / weight, sigma);
    errors.add(error.imag() / weight, sigma);
  }
  return errors;
}

/// How the blend's own spread has held its errors, by day of lead.
EarnedSpread spread_of_leads(const std::vector<std::vector<PastLead>>& past, const Earned& earned) {
  std::vector<PastSpread> spreads;
  for (const PastLead& first : past.front()) {
    PastSpread spread;
    spread.age_days = first.age_days;
    spread.errors = normalised(*first.lead, earned.blend);
    for (std::size_t l = 1; l < past.size(); ++l) {
      const auto same = std::find_if(past[l].begin(), past[l].end(),
                                     [&](const PastLead& later) { return later.day == first.day; });
      spread.later.push_back(same == past[l].end() ? NormalisedErrors{}
                                                   : normalised(*same->lead, earned.later[l - 1]));
    }
    spreads.push_back(std::move(spread));
  }
  return earned_spread(spreads);
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
  RehearsedDay result;
  const ForecastPlan past = plan_of(plan, day);
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
    add_errors(current_methods(column, past, snapshot, 0, truth, made.known, &made.tide), truth,
               past.end_of_day(), result);
  }
  for (RehearsedLead& lead : result.lead) clear_absent(lead);
  return result;
}

std::shared_ptr<const RehearsedDay> Rehearsals::day(const ForecastPlan& plan, UtcDay day) {
  const ForecastPlan past = plan_of(plan, day);
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

Earned Rehearsals::earned(const ForecastPlan& asked, const std::vector<bool>& available,
                          int threads) {
  const ForecastPlan plan = with_past_runs(asked, data_, parts_);
  for_all(longest_days, threads,
          [&](std::size_t i) { (void)day(plan, plan.day - days(static_cast<int>(i) + 1)); });
  std::vector<Candidate> candidates = standard_candidates();
  for (std::size_t c = 0; c < candidates.size(); ++c) candidates[c].available = available[c];
  std::vector<std::vector<PastLead>> past(static_cast<std::size_t>(lead_days_of(plan)));
  Earned earned;
  for (int before = longest_days; before >= 1; --before) {
    const auto rehearsed = day(plan, plan.day - days(before));
    if (rehearsed->failure) {
      ++earned.failed_days;
      if (!earned.first_failure) earned.first_failure = rehearsed->failure;
    }
    // Of a day's leads those have a truth that ends by D.
    for (int lead = 1; lead <= std::min(before, lead_days_of(plan)); ++lead) {
      const auto l = static_cast<std::size_t>(lead) - 1;
      if (l >= rehearsed->lead.size()) continue;
      const RehearsedLead& of_day = rehearsed->lead[l];
      if (of_day.errors.empty() || of_day.errors.front().empty()) continue;
      past[l].push_back({rehearsed, &of_day, static_cast<double>(before - lead)});
      if (lead == 1 && rehearsed->simulated_wind) ++earned.simulated_days;
    }
  }
  earned.blend = blend_of_leads(past.front(), candidates);
  for (std::size_t l = 1; l < past.size(); ++l)
    earned.later.push_back(blend_of_leads(past[l], candidates));
  earned.spread = spread_of_leads(past, earned);
  return earned;
}

}  // namespace slackwater::calibration
