#include "calibration/day/given/wind_ensemble.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "fields/base/constants.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Six-hourly steps leave gaps of six hours; a gap of more than twice that is a gap.
constexpr Duration widest_gap = hours(12);
/// What a run has to say at least: the day that skill is judged by.
constexpr Duration shortest_reach = hours(24);
using constants::nan;

using Pieces = std::vector<const PieceColumn<Horizontal>*>;

/// Of the pieces of perturbed members, by run and member.
struct RunKey {
  UtcTime reference_time;
  std::string dataset;
  auto operator<=>(const RunKey&) const = default;
};
using Runs = std::map<RunKey, std::map<int, Pieces>>;

Runs runs_of(const VectorRecord& wind) {
  Runs runs;
  for (const PieceColumn<Horizontal>& piece : wind.pieces) {
    const Origin& origin = *piece.origin;
    if (origin.ensemble_member <= 0 || origin.status != DataStatus::forecast ||
        !origin.reference_time)
      continue;
    runs[{*origin.reference_time, origin.dataset}][origin.ensemble_member].push_back(&piece);
  }
  for (auto& [key, members] : runs) {
    for (auto& [number, pieces] : members) {
      std::sort(pieces.begin(), pieces.end(), [](const auto* a, const auto* b) {
        return std::tie(a->origin->granules, a->origin->sources) <
               std::tie(b->origin->granules, b->origin->sources);
      });
    }
  }
  return runs;
}

VectorColumn empty_series(const GeoPoint& point) {
  VectorColumn series;
  series.point = point;
  return series;
}

void append(VectorColumn& series, UtcTime time, Horizontal value) {
  series.time.push_back(TimeCell::instant(time));
  series.value.push_back(value);
  series.status.push_back(SampleStatus::ok);
  series.source.push_back(DataStatus::forecast);
}

/// One member's values in time up to `until`, as far as they are known; where pieces overlap the
/// last one holds.
VectorColumn joined(const Pieces& pieces, const Knowledge& knowledge, UtcTime until) {
  std::map<UtcTime, Horizontal> values;
  for (const PieceColumn<Horizontal>* piece : pieces) {
    const VectorColumn& column = piece->column;
    for (std::size_t t = 0; t < column.times(); ++t) {
      const UtcTime time = column.time[t].centre();
      if (time <= until && column.has(t) && is_known(*piece->origin, column.time[t], knowledge))
        values[time] = column.value[column.offset(t, 0)];
    }
  }
  VectorColumn series = empty_series(pieces.front()->column.point);
  for (const auto& [time, value] : values) append(series, time, value);
  return series;
}

std::vector<Horizontal> at_stamps(const VectorColumn& series, std::span<const UtcTime> stamps) {
  std::vector<Horizontal> values;
  for (const UtcTime stamp : stamps)
    values.push_back(value_at(series, stamp, widest_gap).value_or(Horizontal(nan, nan)));
  return values;
}

bool reaches_far_enough(const VectorColumn& series, std::span<const UtcTime> stamps) {
  const std::vector<Horizontal> values = at_stamps(series, stamps);
  const auto is_known = [](Horizontal value) { return !std::isnan(value.real()); };
  const auto first = std::find_if(values.begin(), values.end(), is_known);
  if (first == values.end()) return false;
  const auto end = std::find_if_not(first, values.end(), is_known);
  const UtcTime from = stamps[static_cast<std::size_t>(first - values.begin())];
  const UtcTime to = stamps[static_cast<std::size_t>(end - values.begin()) - 1];
  return to - from >= shortest_reach || (first == values.begin() && end == values.end());
}

/// @param takes_part  whether a member says enough
template <typename TakesPart>
WindEnsemble ensemble_of(const RunKey& key, const std::map<int, Pieces>& members,
                         const Knowledge& knowledge, UtcTime until, TakesPart takes_part) {
  WindEnsemble ensemble;
  ensemble.run.dataset = key.dataset;
  ensemble.run.reference_time = key.reference_time;
  for (const auto& [number, pieces] : members) {
    VectorColumn series = joined(pieces, knowledge, until);
    if (!takes_part(series)) continue;
    ensemble.run.number.push_back(number);
    ensemble.members.push_back(std::move(series));
    for (const auto* piece : pieces) ensemble.run.origins.push_back(piece->origin);
  }
  if (!ensemble.run.origins.empty())
    ensemble.run.product_id = ensemble.run.origins.front()->product_id;
  return ensemble;
}

}  // namespace

std::optional<WindEnsemble> newest_wind_ensemble(const VectorRecord& wind,
                                                 const Knowledge& knowledge,
                                                 std::span<const UtcTime> stamps) {
  const Runs runs = runs_of(wind);
  std::optional<WindEnsemble> best;
  for (auto run = runs.rbegin(); run != runs.rend(); ++run) {
    const auto& [key, members] = *run;
    if (best && key.reference_time < best->run.reference_time) break;
    WindEnsemble ensemble =
        ensemble_of(key, members, knowledge, UtcTime::max(),
                    [&](const VectorColumn& series) { return reaches_far_enough(series, stamps); });
    // Datasets come in falling order: of equals the later one is first by name.
    if (ensemble.members.size() >= fewest_wind_members &&
        (!best || ensemble.members.size() >= best->members.size()))
      best = std::move(ensemble);
  }
  return best;
}

std::vector<WindEnsemble> wind_ensembles(const VectorRecord& wind, const std::string& dataset,
                                         const Knowledge& knowledge, UtcTime until) {
  std::vector<WindEnsemble> ensembles;
  for (const auto& [key, members] : runs_of(wind)) {
    if (key.dataset != dataset || key.reference_time >= until) continue;
    WindEnsemble ensemble =
        ensemble_of(key, members, knowledge, until,
                    [](const VectorColumn& series) { return series.times() > 0; });
    if (!ensemble.members.empty()) ensembles.push_back(std::move(ensemble));
  }
  return ensembles;
}

std::vector<WindMember> members_at(const WindEnsemble& ensemble, std::span<const UtcTime> stamps) {
  std::vector<WindMember> members;
  for (std::size_t m = 0; m < ensemble.members.size(); ++m)
    members.push_back({ensemble.run.number[m], at_stamps(ensemble.members[m], stamps)});
  return members;
}

}  // namespace slackwater::calibration
