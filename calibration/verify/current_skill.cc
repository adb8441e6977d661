#include "calibration/verify/current_skill.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/column/methods.h"
#include "calibration/day/truth.h"
#include "fields/base/constants.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/parallel.h"

namespace slackwater::calibration {
namespace {

/// Columns are tallied in this many groups, added up in order: a sum in floating point must not
/// depend on which thread was first.
constexpr std::size_t groups = 16;

/// One forecast under the ruler.
struct Scored {
  const SiteData& data;
  const Snapshot& snapshot;
  const VerifyOptions& options;
  const SkillEntry& blank;
  const ForecastPlan& plan;
  const std::vector<DepthBand>& bands;
  std::size_t hours = 0;
};

/// What one column, or a group of columns, adds up to.
struct Sum {
  TalliesByMethod methods;
  std::vector<SkillEntry> column_entries;
  std::optional<ForecastTrace> trace;
  std::string truth;
  Duration truth_averaging{0};  ///< the longest of any column
};

std::vector<std::size_t> bands_of(const Scored& scored, double depth_m, double water_depth_m) {
  std::vector<std::size_t> found;
  for (std::size_t band = 0; band < scored.bands.size(); ++band)
    if (holds(scored.bands[band], depth_m, water_depth_m)) found.push_back(band);
  return found;
}

/// @param ours  our own forecast of the column; null where it has none
void tally(const Scored& scored, const MethodForecast& method, const MethodForecast* ours,
           const VectorColumn& truth, double water_depth_m, TalliesByMethod& sums) {
  MethodTallies& tallies =
      sums.try_emplace(method.method, scored.bands.size(), scored.hours).first->second;
  for (std::size_t k = 0; k < truth.levels(); ++k) {
    const std::vector<std::size_t> bands = bands_of(scored, truth.levels_m[k], water_depth_m);
    for (std::size_t t = 0; t < truth.times(); ++t) {
      const std::size_t o = truth.offset(t, k);
      if (!has_value(truth.status[o]) || !method.made.has(o)) continue;
      const auto hour = hour_of_lead(scored.plan.end_of_day(), truth.time[t].centre());
      if (!hour || *hour >= scored.hours) continue;
      const PairContribution pair =
          method.sigma_m_s.empty()
              ? contribution_of(method.made.value[o], truth.value[o])
              : contribution_of(method.made.value[o], truth.value[o], method.sigma_m_s[o]);
      const bool is_common = ours != nullptr && ours->made.has(o);
      const double error = is_common ? std::norm(ours->made.value[o] - truth.value[o]) : 0.0;
      for (const std::size_t band : bands) {
        if (is_common) {
          tallies.add(band, *hour, pair, error);
        } else {
          tallies.add_alone(band, *hour, pair);
        }
      }
    }
  }
}

/// Adds a column's misfit to a trace; the first column is also drawn.
void trace_column(const VectorColumn& truth, const MethodForecast& forecast, double water_depth_m,
                  std::optional<ForecastTrace>& trace) {
  const bool first = !trace;
  if (first) {
    trace.emplace();
    trace->point = truth.point;
    trace->depth_m = truth.levels_m;
  }
  trace->water_depth_m = std::max(trace->water_depth_m, water_depth_m);
  using constants::nan;
  for (std::size_t t = 0; t < truth.times(); ++t) {
    const UtcTime time = truth.time[t].centre();
    if (first) trace->time.push_back(time);
    for (std::size_t k = 0; k < truth.levels(); ++k) {
      const std::size_t o = truth.offset(t, k);
      const bool both = has_value(truth.status[o]) && forecast.made.has(o);
      if (first) {
        trace->forecast_m_s.push_back(both ? forecast.made.value[o] : Horizontal(nan, nan));
        trace->truth_m_s.push_back(both ? truth.value[o] : Horizontal(nan, nan));
      }
      if (!both) continue;
      BlockSum& cell = trace->misfit[{time, truth.levels_m[k]}];
      cell.sum += std::norm(forecast.made.value[o] - truth.value[o]);
      cell.weight += 1;
    }
  }
}

void merge(std::optional<ForecastTrace>& all, std::optional<ForecastTrace>&& more) {
  if (!more) return;
  if (!all) {
    all = std::move(more);
    return;
  }
  all->water_depth_m = std::max(all->water_depth_m, more->water_depth_m);
  for (const auto& [place, sum] : more->misfit) {
    all->misfit[place].sum += sum.sum;
    all->misfit[place].weight += sum.weight;
  }
}

void score_column(const Scored& scored, std::size_t index, Sum& sum) {
  const ForecastColumn& issued = scored.snapshot.columns[index];
  const ColumnData* column = scored.data.column_at(issued.point);
  if (column == nullptr) return;
  const Chosen<Horizontal> truth = truth_of(
      *column, scored.plan.stands_in_for.empty() ? scored.plan.dataset : scored.plan.stands_in_for,
      scored.plan.end_of_day(), std::min(scored.snapshot.time.back(), scored.options.truth_until));
  if (truth.empty()) return;
  sum.truth = truth_name(*truth.origin.back());
  const Duration averaging = averaging_of(truth.column.time);
  sum.truth_averaging = std::max(sum.truth_averaging, averaging);
  const std::vector<MethodForecast> methods = current_methods(
      *column, scored.plan, scored.snapshot, index, truth,
      known_beside(truth, *column, scored.plan), known_provider(*column, scored.plan));
  const bool apart = scored.options.per_column && scored.snapshot.columns.size() > 1;
  const auto ours = std::find_if(methods.begin(), methods.end(), [](const MethodForecast& m) {
    return m.method == Method::forecast;
  });
  TalliesByMethod own;
  for (const MethodForecast& method : methods) {
    tally(scored, method, ours == methods.end() ? nullptr : &*ours, truth.column,
          issued.water_depth_m, apart ? own : sum.methods);
    if (scored.options.traces && method.method == Method::forecast)
      trace_column(truth.column, method, issued.water_depth_m, sum.trace);
  }
  if (!apart) return;
  SkillEntry blank = scored.blank;
  blank.column = index;
  blank.truth = sum.truth;
  blank.truth_averaging = averaging;
  auto entries = entries_of(own, scored.bands, scored.options, blank, false);
  std::move(entries.begin(), entries.end(), std::back_inserter(sum.column_entries));
  slackwater::calibration::merge(sum.methods, own);
}

ForecastPlan plan_of(const Snapshot& snapshot, const CurrentSource& currents, bool from_archive,
                     const SkillEntry& blank) {
  ForecastPlan plan;
  plan.day = snapshot.day;
  plan.issued = snapshot.issued;
  if (!from_archive) plan.seen_by = snapshot.issued;
  plan.best.issued = snapshot.issued;
  plan.best.seen_by = plan.seen_by;
  plan.wind = blank.wind;
  plan.dataset = currents.dataset;
  plan.stands_in_for = currents.stands_in_for;
  return plan;
}

/// Hours of lead that are asked for and that the forecast reaches.
std::size_t hours_to_score(const VerifyOptions& options, const Snapshot& snapshot,
                           UtcTime end_of_day) {
  double last = 0;
  for (const LeadBin& lead : options.leads) last = std::max(last, lead.to_h);
  const double reach = std::ceil(hours_between(end_of_day, snapshot.time.back()) - 1e-9);
  return static_cast<std::size_t>(std::max(0.0, std::min(std::ceil(last), reach)));
}

}  // namespace

std::string truth_name(const Origin& origin) {
  return origin.is_point_series ? "station " + origin.station : origin.product_id;
}

ForecastSkill score_currents(const SiteData& data, const Snapshot& snapshot,
                             const CurrentSource& currents, const VerifyOptions& options,
                             const SkillEntry& blank) {
  ForecastSkill skill;
  if (currents.dataset.empty() || snapshot.columns.empty()) return skill;
  const std::vector<DepthBand> bands = options.bands.empty() ? standard_bands() : options.bands;
  const ForecastPlan plan = plan_of(snapshot, currents, options.from_archive, blank);
  const Scored scored{data,
                      snapshot,
                      options,
                      blank,
                      plan,
                      bands,
                      hours_to_score(options, snapshot, plan.end_of_day())};
  const std::size_t count = snapshot.columns.size();
  std::vector<Sum> sums(std::min(groups, count));
  for_all(sums.size(), options.threads, [&](std::size_t g) {
    const std::size_t first = g * count / sums.size();
    const std::size_t last = (g + 1) * count / sums.size();
    for (std::size_t i = first; i < last; ++i) score_column(scored, i, sums[g]);
  });
  Sum all;
  for (Sum& sum : sums) {
    slackwater::calibration::merge(all.methods, sum.methods);
    merge(all.trace, std::move(sum.trace));
    std::move(sum.column_entries.begin(), sum.column_entries.end(),
              std::back_inserter(skill.entries));
    if (!sum.truth.empty()) all.truth = sum.truth;
    all.truth_averaging = std::max(all.truth_averaging, sum.truth_averaging);
  }
  SkillEntry pooled = blank;
  pooled.truth = all.truth;
  pooled.truth_averaging = all.truth_averaging;
  auto entries = entries_of(all.methods, bands, options, pooled, true);
  std::move(entries.begin(), entries.end(), std::back_inserter(skill.entries));
  if (all.trace) {
    all.trace->day = snapshot.day;
    all.trace->issued = snapshot.issued;
    all.trace->origin = blank.origin;
    all.trace->wind = blank.wind;
    all.trace->truth = all.truth;
  }
  skill.trace = std::move(all.trace);
  return skill;
}

}  // namespace slackwater::calibration
