#include "calibration/day/given/horizon.h"

#include <algorithm>
#include <cmath>

#include "calibration/day/given/horizon_input.h"
#include "fields/base/constants.h"
#include "fields/interpolate/temporal.h"
#include "fields/wave/growth.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Waves change more slowly than wind and come 1- to 6-hourly.
constexpr Duration widest_wave_gap = hours(12);

/// Where the stored value nearest to a time stands.
template <typename T>
std::size_t nearest_index(const Column<T>& column, UtcTime time) {
  std::size_t best = 0;
  for (std::size_t t = 1; t < column.times(); ++t) {
    const auto distance = [&](std::size_t i) {
      return std::chrono::abs(column.time[i].centre() - time);
    };
    if (distance(t) <= distance(best)) best = t;
  }
  return best;
}

/// The newest time before `stamp` at which the store knows the waves, at most two days back.
std::optional<UtcTime> last_known(const Chosen<double>& height, UtcTime stamp) {
  for (std::size_t i = height.column.times(); i-- > 0;) {
    const UtcTime centre = height.column.time[i].centre();
    if (height.column.has(i) && centre <= stamp) {
      return stamp - centre <= hours(48) ? std::optional(centre) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// How far back the wind is followed where no sea is known: what it raised before is swell by then.
constexpr Duration longest_spin_up = hours(48);
constexpr SeaState unknown_sea{constants::nan, constants::nan, constants::nan};

/// Directions as unit vectors, which may be averaged and moved.
VectorRecord as_vectors(const ScalarRecord& from_direction) {
  VectorRecord record;
  for (const PieceColumn<double>& piece : from_direction.pieces) {
    PieceColumn<Horizontal> vectors{piece.origin, {}, piece.distance_m};
    VectorColumn& column = vectors.column;
    column.point = piece.column.point;
    column.time = piece.column.time;
    column.status = piece.column.status;
    column.source = piece.column.source;
    for (const double from_deg : piece.column.value)
      column.value.push_back(vector_to_direction(1, from_deg));
    record.pieces.push_back(std::move(vectors));
  }
  return record;
}

/// A sea and the time it is of.
struct SeaAt {
  UtcTime time;
  SeaState sea;
};

/// Since when the wind before a stamp is known, in whole hours and at most `longest_spin_up`; the
/// stamp itself where it is not.
UtcTime spin_up_from(const HorizonWind& wind, UtcTime stamp) {
  UtcTime from = stamp;
  while (stamp - from < longest_spin_up && wind.series->time.front().centre() <= from - hours(1)) {
    from -= hours(1);
  }
  return from;
}

/// A sea that the wind has raised for half a day where none was.
SeaState raised_sea(Horizontal wind, const WaveSetting& setting) {
  constexpr double half_day_s = 43200;
  const double from_deg = from_direction_deg(wind);
  const WindSea sea = limited_wind_sea(std::abs(wind), setting.fetch.at_m(from_deg), half_day_s,
                                       setting.water_depth_m);
  return {sea.significant_height_m, sea.peak_period_s, from_deg};
}

/// The sea at stamps [first, stamps.size()), carried on by the wind from the one known before them;
/// where none is known, from what the wind raised on calm water since two days before, or since the
/// wind is known.
std::vector<SeaState> grow_sea(const std::optional<SeaAt>& known, std::span<const UtcTime> stamps,
                               std::size_t first, const HorizonWind& wind,
                               const WaveSetting& setting) {
  if (wind.wind_m_s.empty())
    return std::vector<SeaState>(stamps.size() - first, known ? known->sea : unknown_sea);
  std::vector<Horizontal> blown;
  const auto wind_at = [&](UtcTime time) {
    if (time < stamps.front()) {
      const Horizontal last = blown.empty() ? wind.wind_m_s.front() : blown.back();
      return value_at(*wind.series, time, hours(12)).value_or(last);
    }
    const auto after = std::upper_bound(stamps.begin(), stamps.end(), time);
    return wind.wind_m_s[static_cast<std::size_t>(after - stamps.begin()) - 1];
  };
  for (UtcTime time = known ? known->time : spin_up_from(wind, stamps[first]); time < stamps[first];
       time += hours(1)) {
    blown.push_back(wind_at(time));
  }
  const std::size_t skipped = blown.size();
  blown.insert(blown.end(), wind.wind_m_s.begin() + static_cast<std::ptrdiff_t>(first),
               wind.wind_m_s.begin() + static_cast<std::ptrdiff_t>(stamps.size()));
  const SeaState start = known ? known->sea : raised_sea(blown.front(), setting);
  const std::vector<SeaState> sea = propagate_sea_state(start, blown, setting);
  return {sea.begin() + static_cast<std::ptrdiff_t>(skipped), sea.end()};
}

}  // namespace

HorizonSea horizon_sea(const ColumnData& column, const Site& site, WindPolicy policy,
                       UtcTime end_of_day, std::span<const UtcTime> stamps, const HorizonWind& wind,
                       const BestInputs& best) {
  HorizonSea result;
  const Chosen<double> height = choose_input(column.significant_height, policy, end_of_day, best);
  // Period and direction are those of the run whose height it is.
  const Chosen<double> period =
      choose_input(column.peak_period, policy, end_of_day, best, &height.stretches);
  const Chosen<Horizontal> heading =
      choose_input(as_vectors(column.wave_direction), policy, end_of_day, best, &height.stretches);
  result.hindsight =
      looks_ahead(height, best) || looks_ahead(period, best) || looks_ahead(heading, best);
  result.stretches = height.stretches;
  if (height.empty() && wind.wind_m_s.empty()) return result;
  constexpr double unknown = constants::nan;
  const auto at = [](const Chosen<double>& chosen, UtcTime time) {
    return chosen.empty() ? std::nullopt : value_at(chosen.column, time, widest_wave_gap);
  };
  const auto stored_at = [&](UtcTime time) -> std::optional<SeaState> {
    const auto stored = at(height, time);
    if (!stored) return std::nullopt;
    const auto toward = value_at(heading.column, time, widest_wave_gap);
    return SeaState{std::max(0.0, *stored), at(period, time).value_or(unknown),
                    toward ? to_direction_deg(*toward) : unknown};
  };
  WaveSetting setting;
  if (site.fetch) setting.fetch = *site.fetch;
  setting.water_depth_m = std::max(1.0, column.water_depth.depth_m);

  std::size_t t = 0;
  while (t < stamps.size()) {
    if (const auto stored = stored_at(stamps[t])) {
      const std::size_t nearest = nearest_index(height.column, stamps[t]);
      result.sea.push_back(*stored);
      result.source.push_back(height.column.source[nearest]);
      result.origins.push_back(height.origin[nearest]);
      ++t;
      continue;
    }
    // A run of stamps without stored waves: grow them from the state before it.
    std::size_t end = t;
    while (end < stamps.size() && !stored_at(stamps[end])) ++end;
    std::optional<SeaAt> known;
    if (t > 0) {
      known = {stamps[t - 1], result.sea.back()};
    } else if (const auto then = last_known(height, stamps[0])) {
      if (const auto sea = stored_at(*then)) known = {*then, *sea};
      result.carried_from = *then;
      result.origins.push_back(height.origin[nearest_index(height.column, stamps[0])]);
    }
    const std::vector<SeaState> grown = grow_sea(known, stamps.subspan(0, end), t, wind, setting);
    for (const SeaState& state : grown) {
      result.sea.push_back(state);
      result.source.push_back(wind.wind_m_s.empty() ? DataStatus::persisted : DataStatus::modelled);
    }
    t = end;
  }
  return result;
}

}  // namespace slackwater::calibration
