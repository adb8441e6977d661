#include "calibration/day/column/unresolved_tide.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "calibration/day/column/column_calibration.h"
#include "calibration/day/column/tide_of_record.h"
#include "fields/base/numbers/averaging.h"
#include "fields/base/numbers/random.h"
#include "fields/record/choose.h"
#include "fields/record/slice.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Half of a lunar day, in hourly stamps.
constexpr std::size_t reach = 12;

/// A record that shows the tide.
struct TidalRecord {
  std::vector<double> levels_m;
  FittedTide tide;
  std::string name;
  std::vector<const Origin*> origins;
  Duration length{0};

  /// The level nearest in depth of those with a tide.
  [[nodiscard]] std::size_t level_near(double depth_m) const {
    std::size_t nearest = 0;
    double least_m = -1;
    for (std::size_t k = 0; k < tide.levels.size(); ++k) {
      const double apart_m = std::abs(levels_m[k] - depth_m);
      if (tide.levels[k].terms.empty() || (least_m >= 0 && apart_m >= least_m)) continue;
      nearest = k;
      least_m = apart_m;
    }
    return nearest;
  }
};

Duration length_of(const VectorColumn& column) {
  Duration longest(0);
  std::vector<SampleStatus> status(column.times());
  for (std::size_t k = 0; k < column.levels(); ++k) {
    for (std::size_t t = 0; t < column.times(); ++t) status[t] = column.status[column.offset(t, k)];
    longest = std::max(longest, record_length(column.time, status));
  }
  return longest;
}

std::string name_of(const Origin& origin) {
  return origin.is_point_series ? "station " + origin.station : origin.product_id;
}

/// One dataset up to the end of D, as a record of the tide; nothing where it shows none.
std::optional<TidalRecord> tidal_record_of(const ColumnData& data, const ForecastPlan& plan,
                                           const std::string& dataset) {
  Choice choice;
  choice.dataset = dataset;
  const Chosen<Horizontal> chosen = choose(data.current, plan.knowledge(), choice);
  if (chosen.empty() || !tide_since(chosen, plan.day)) return std::nullopt;
  VectorColumn column = slice(chosen.column, UtcTime::min(), plan.end_of_day());
  if (column.levels_m.empty()) column.levels_m = {0.0};  // a product of the surface
  if (hides_the_tide(averaging_of(column.time))) return std::nullopt;
  TidalRecord record;
  record.length = length_of(column);
  record.tide = fit_column_tide(column, data.point.latitude);
  if (record.tide.levels.empty()) return std::nullopt;
  record.levels_m = column.levels_m;
  record.name = name_of(*chosen.origin.front());
  record.origins = chosen.origin;
  return record;
}

/// The longest record of the tide beside the plan's own dataset.
std::optional<TidalRecord> tidal_record(const ColumnData& data, const ForecastPlan& plan) {
  std::set<std::string> datasets;
  for (const auto& piece : data.current.pieces) datasets.insert(piece.origin->dataset);
  datasets.erase(plan.dataset);
  std::optional<TidalRecord> longest;
  for (const std::string& dataset : datasets) {
    auto record = tidal_record_of(data, plan, dataset);
    if (record && (!longest || record->length > longest->length)) longest = std::move(record);
  }
  return longest;
}

/// Variance along the longest axis of what goes round about zero, over 2 `reach` + 1 values from
/// `first`.
double variance_along_axis(const std::vector<Horizontal>& values, std::size_t first) {
  double power = 0;
  Horizontal square{};
  for (std::size_t i = first; i <= first + 2 * reach; ++i) {
    power += std::norm(values[i]);
    square += values[i] * values[i];
  }
  return 0.5 * (power + std::abs(square)) / (2 * reach + 1);
}

/// How far each member's tide is from that of the stamps, hours; members come in pairs of opposite
/// sign, which share one.
std::vector<std::size_t> phases_of(std::size_t members, std::uint64_t seed) {
  Rng random(seed, "calibration/unresolved_tide");
  std::vector<std::size_t> phase;
  for (std::size_t m = 0; m < members; ++m) {
    phase.push_back(m % 2 == 1 ? phase.back()
                               : static_cast<std::size_t>(random.uniform(0, 2 * reach + 1)));
  }
  return phase;
}

}  // namespace

std::optional<UnresolvedTide> widen_by_unresolved_tide(ForecastColumn& column,
                                                       const ColumnData& data,
                                                       const Chosen<Horizontal>& known,
                                                       const ForecastPlan& plan) {
  UnresolvedTide found;
  AveragedCurrents& averaged = found.averaged;
  averaged.averaging = averaging_of(slice(known.column, UtcTime(plan.day), plan.end_of_day()).time);
  if (!hides_the_tide(averaged.averaging)) return std::nullopt;
  const FittedTide own = tide_of_record(known, plan.day, data.point.latitude);
  averaged.holds_part_of_the_tide = !own.levels.empty();
  const std::optional<TidalRecord> record = tidal_record(data, plan);
  if (!record) return found;
  found.origins = record->origins;
  averaged.tidal_record = record->name;
  averaged.unresolved_tide_m_s = 0;

  const std::size_t levels = plan.depth_m.size();
  const std::size_t size = column.current_m_s.size();
  const std::size_t members = size > 0 ? column.member_m_s.size() / size : 0;
  const std::vector<std::size_t> phase = phases_of(members, plan.seed);
  std::vector<Horizontal> left_out(plan.stamps.size() + 2 * reach);
  for (std::size_t k = 0; k < levels; ++k) {
    const TideFit& tide = record->tide.levels[record->level_near(plan.depth_m[k])];
    for (std::size_t i = 0; i < left_out.size(); ++i) {
      const TimeCell stamp =
          TimeCell::instant(plan.stamps.front() + hours(static_cast<int>(i)) - hours(reach));
      left_out[i] = tidal_oscillation(tide, stamp) -
                    (k < known.column.levels() ? own.at(k, stamp) : Horizontal{});
    }
    for (std::size_t t = 0; t < plan.stamps.size(); ++t) {
      const std::size_t o = t * levels + k;
      if (!has_value(column.current_status[o])) continue;
      const double variance = variance_along_axis(left_out, t);
      averaged.unresolved_tide_m_s = std::max(*averaged.unresolved_tide_m_s, std::sqrt(variance));
      column.current_sigma_m_s[o] = std::hypot(column.current_sigma_m_s[o], std::sqrt(variance));
      for (std::size_t m = 0; m < members; ++m) {
        const double sign = m % 2 == 1 ? -1.0 : 1.0;
        column.member_m_s[m * size + o] += sign * left_out[t + phase[m]];
      }
    }
  }
  return found;
}

}  // namespace slackwater::calibration
