#include "calibration/verify/surface_skill.h"

#include <cmath>
#include <map>

#include "calibration/day/given/surface_truth.h"
#include "calibration/verify/current_skill.h"
#include "fields/base/numbers/averaging.h"
#include "fields/interpolate/temporal.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Method and truth at one time, our forecast beside them; scalars travel as vectors with a zero
/// north component.
struct SurfacePair {
  Horizontal made{};
  Horizontal ours{};
  Horizontal truth{};
  double lead_h = 0;
  std::size_t hour = 0;  ///< of UTC
};

SurfacePair pair_at(Horizontal made, Horizontal ours, Horizontal truth, UtcTime time, UtcTime end) {
  return {made, ours, truth, hours_between(end, time),
          static_cast<std::size_t>(time.time_since_epoch() / hours(1))};
}

/// Persistence: the last value that was known when the forecast was issued, of the day before it at
/// most. It knows what the forecast knew, hours after D among it.
template <typename T>
std::optional<T> last_known(const Record<T>& record, UtcTime issued, UtcTime seen_by) {
  Knowledge knowledge;
  knowledge.values_until = issued;
  knowledge.seen_by = seen_by;
  const Chosen<T> known = surface_truth(record, knowledge);
  for (std::size_t t = known.column.times(); t-- > 0;) {
    const UtcTime time = known.column.time[t].centre();
    if (time > issued || !known.column.has(t)) continue;
    if (time <= issued - hours(24)) return std::nullopt;
    return known.column.value[t];
  }
  return std::nullopt;
}

/// An archive was read later than its forecasts were issued: nothing of it is hidden.
UtcTime seen_by(const Snapshot& snapshot, const VerifyOptions& options) {
  return options.from_archive ? UtcTime::max() : snapshot.issued;
}

std::vector<SurfacePair> within(const std::vector<SurfacePair>& pairs, const LeadBin& lead) {
  std::vector<SurfacePair> part;
  for (const SurfacePair& pair : pairs)
    if (pair.lead_h > lead.from_h && pair.lead_h <= lead.to_h) part.push_back(pair);
  return part;
}

void score(SkillEntry& entry, const std::vector<SurfacePair>& pairs, bool scalar) {
  std::vector<Horizontal> made;
  std::vector<Horizontal> truth;
  std::vector<double> height;
  std::vector<double> true_height;
  std::vector<double> squared;
  std::vector<std::size_t> hour;
  double ours_squared = 0;
  for (const SurfacePair& pair : pairs) {
    made.push_back(pair.made);
    truth.push_back(pair.truth);
    height.push_back(pair.made.real());
    true_height.push_back(pair.truth.real());
    squared.push_back(std::norm(pair.made - pair.truth));
    hour.push_back(pair.hour);
    ours_squared += std::norm(pair.ours - pair.truth);
  }
  if (scalar) {
    entry.scalar = score_scalars(height, true_height);
  } else {
    entry.vector = score_vectors(made, truth);
  }
  if (entry.method != Method::forecast)
    entry.forecast_rmse = std::sqrt(ours_squared / static_cast<double>(pairs.size()));
  Rng random(static_cast<std::uint64_t>(entry.day.time_since_epoch().count()), "verify/bootstrap");
  entry.interval = bootstrap_rmse(squared, hour, random, 1000);
}

using PairsByMethod = std::map<Method, std::vector<SurfacePair>>;

void add_entries(const PairsByMethod& methods, const VerifyOptions& options,
                 const SkillEntry& blank, bool scalar, std::vector<SkillEntry>& entries) {
  for (const LeadBin& lead : options.leads) {
    for (const auto& [method, pairs] : methods) {
      const std::vector<SurfacePair> part = within(pairs, lead);
      if (part.empty()) continue;
      SkillEntry entry = blank;
      entry.method = method;
      entry.lead = lead;
      score(entry, part, scalar);
      entries.push_back(std::move(entry));
    }
  }
}

void score_wind(const ColumnData& data, const Snapshot& snapshot, UtcTime end,
                const VerifyOptions& options, SkillEntry blank, std::vector<SkillEntry>& entries) {
  const ForecastColumn& column = snapshot.columns.front();
  if (column.wind_m_s.empty()) return;
  const Chosen<Horizontal> truth = surface_truth(data.wind);
  const UtcTime issued = std::max(end, snapshot.issued);
  const auto last = last_known(data.wind, issued, seen_by(snapshot, options));
  PairsByMethod methods;
  for (std::size_t t = 0; t < truth.column.times(); ++t) {
    if (!truth.column.has(t) || truth.column.time[t].end > options.truth_until) continue;
    const UtcTime time = truth.column.time[t].centre();
    const Horizontal value = truth.column.value[t];
    if (time <= end) continue;
    if (is_its_own_truth(snapshot.time, column.wind_source, time, *truth.origin[t])) continue;
    const auto forecast = mean_over(snapshot.time, column.wind_m_s, 1, 0, TimeCell::instant(time));
    if (!forecast) continue;
    methods[Method::forecast].push_back(pair_at(*forecast, *forecast, value, time, end));
    if (last && time > issued)
      methods[Method::persistence].push_back(pair_at(*last, *forecast, value, time, end));
  }
  if (methods.empty()) return;
  blank.variable = wind_variable;
  blank.truth = truth_name(*truth.origin.back());
  blank.truth_averaging = averaging_of(truth.column.time);
  add_entries(methods, options, blank, false, entries);
}

void score_waves(const ColumnData& data, const Snapshot& snapshot, UtcTime end,
                 const VerifyOptions& options, SkillEntry blank, std::vector<SkillEntry>& entries) {
  const ForecastColumn& column = snapshot.columns.front();
  if (column.sea.empty()) return;
  const Chosen<double> truth = surface_truth(data.significant_height);
  std::vector<Horizontal> height;
  for (const SeaState& sea : column.sea) height.emplace_back(sea.significant_height_m, 0);
  const UtcTime issued = std::max(end, snapshot.issued);
  const auto last = last_known(data.significant_height, issued, seen_by(snapshot, options));
  PairsByMethod methods;
  for (std::size_t t = 0; t < truth.column.times(); ++t) {
    if (!truth.column.has(t) || truth.column.time[t].end > options.truth_until) continue;
    const UtcTime time = truth.column.time[t].centre();
    const double value = truth.column.value[t];
    if (time <= end) continue;
    if (is_its_own_truth(snapshot.time, column.sea_source, time, *truth.origin[t])) continue;
    const auto forecast = mean_over(snapshot.time, height, 1, 0, TimeCell::instant(time));
    if (!forecast || std::isnan(forecast->real())) continue;
    methods[Method::forecast].push_back(pair_at(*forecast, *forecast, value, time, end));
    if (last && time > issued)
      methods[Method::persistence].push_back(pair_at(*last, *forecast, value, time, end));
  }
  if (methods.empty()) return;
  blank.variable = wave_variable;
  blank.truth = truth_name(*truth.origin.back());
  blank.truth_averaging = averaging_of(truth.column.time);
  add_entries(methods, options, blank, true, entries);
}

}  // namespace

std::vector<SkillEntry> score_surface(const ColumnData& data, const Snapshot& snapshot,
                                      UtcTime end_of_day, const VerifyOptions& options,
                                      const SkillEntry& blank) {
  std::vector<SkillEntry> entries;
  score_wind(data, snapshot, end_of_day, options, blank, entries);
  score_waves(data, snapshot, end_of_day, options, blank, entries);
  return entries;
}

}  // namespace slackwater::calibration
