#include "calibration/day/horizon.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "calibration/propagate/wind_error.h"
#include "fields/interpolate/temporal.h"
#include "fields/record/choose.h"
#include "fields/record/slice.h"
#include "fields/wave/growth.h"

namespace slackwater::calibration {
namespace {

using std::chrono::hours;

/// Six-hourly analyses leave gaps of six hours; a gap of more than twice that is a gap.
constexpr Duration widest_wind_gap = hours(12);
/// Waves change more slowly than wind and come 1- to 6-hourly.
constexpr Duration widest_wave_gap = hours(12);

Knowledge known_by(UtcTime time) { return {time, time, time}; }

Knowledge knowledge_of(WindPolicy policy, UtcTime end_of_day, const BestInputs& best) {
  switch (policy) {
    case WindPolicy::best:
      return best.hindsight ? Knowledge{} : known_by(best.known_by);
    case WindPolicy::forecast:
    case WindPolicy::persist:
      return {end_of_day, end_of_day};
  }
  return {};
}

/// Products where any are known, else moored instruments; with `persist` nothing that is valid
/// after D.
template <typename T>
Chosen<T> choose_input(const Record<T>& record, WindPolicy policy, UtcTime end_of_day,
                       const BestInputs& best) {
  const Knowledge knowledge = knowledge_of(policy, end_of_day, best);
  Choice grids;
  grids.only_grids = true;
  Chosen<T> chosen = choose(record, knowledge, grids);
  if (chosen.empty()) chosen = choose(record, knowledge, {});
  if (policy == WindPolicy::persist) {
    chosen.column = slice(chosen.column, UtcTime::min(), end_of_day);
    chosen.origin.resize(chosen.column.times());
  }
  return chosen;
}

/// Whether any value was not known when `best` says.
template <typename T>
bool looks_ahead(const Chosen<T>& chosen, const BestInputs& best) {
  for (std::size_t t = 0; t < chosen.column.times(); ++t) {
    if (!is_known(*chosen.origin[t], chosen.column.time[t], known_by(best.known_by))) return true;
  }
  return false;
}

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

void append(VectorColumn& series, UtcTime time, Horizontal value, DataStatus source) {
  series.time.push_back(TimeCell::instant(time));
  series.value.push_back(value);
  series.status.push_back(SampleStatus::ok);
  series.source.push_back(source);
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
constexpr SeaState unknown_sea{std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::quiet_NaN()};

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
      return value_at(*wind.series, time, widest_wind_gap).value_or(last);
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

HorizonWind horizon_wind(const VectorRecord& wind, WindPolicy policy, UtcTime end_of_day,
                         std::span<const UtcTime> stamps, const BestInputs& best) {
  HorizonWind result;
  const Chosen<Horizontal> known = choose_input(wind, policy, end_of_day, best);
  result.hindsight = looks_ahead(known, best);
  const VectorColumn& column = known.column;
  VectorColumn series;
  series.point = column.point;
  Horizontal sum{};
  double count = 0;
  std::optional<Horizontal> last;
  UtcTime last_time{};
  for (std::size_t t = 0; t < column.times(); ++t) {
    const UtcTime centre = column.time[t].centre();
    if (!column.has(t)) continue;
    append(series, centre, column.value[t], column.source[t]);
    result.origins.push_back(known.origin[t]);
    sum += column.value[t];
    count += 1;
    last = column.value[t];
    last_time = centre;
  }
  if (!last) return result;
  const Horizontal mean = sum / count;
  for (const UtcTime stamp : stamps) {
    const auto value = stamp <= last_time ? value_at(series, stamp, widest_wind_gap) : std::nullopt;
    if (value) {
      result.wind_m_s.push_back(*value);
      result.source.push_back(column.source[nearest_index(column, stamp)]);
      continue;
    }
    // Persisted wind relaxes to the mean of the known record.
    const double age_h = std::max(0.0, hours_between(last_time, stamp));
    const double weight = std::exp(-age_h / wind_memory_h);
    result.wind_m_s.push_back(weight * *last + (1 - weight) * mean);
    result.source.push_back(DataStatus::persisted);
  }
  // Calibration and propagation see one series: stored values, then the stamps beyond the last of
  // them.
  for (std::size_t t = 0; t < stamps.size(); ++t) {
    if (stamps[t] > last_time) append(series, stamps[t], result.wind_m_s[t], result.source[t]);
  }
  result.series = std::move(series);
  return result;
}

HorizonSea horizon_sea(const ColumnData& column, const Site& site, WindPolicy policy,
                       UtcTime end_of_day, std::span<const UtcTime> stamps, const HorizonWind& wind,
                       const BestInputs& best) {
  HorizonSea result;
  const Chosen<double> height = choose_input(column.significant_height, policy, end_of_day, best);
  const Chosen<double> period = choose_input(column.peak_period, policy, end_of_day, best);
  const Chosen<double> direction = choose_input(column.wave_direction, policy, end_of_day, best);
  result.hindsight =
      looks_ahead(height, best) || looks_ahead(period, best) || looks_ahead(direction, best);
  if (height.empty() && wind.wind_m_s.empty()) return result;
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  const auto at = [](const Chosen<double>& chosen, UtcTime time) {
    return chosen.empty() ? std::nullopt : value_at(chosen.column, time, widest_wave_gap);
  };
  // Directions pass through unit vectors.
  VectorColumn heading;
  for (std::size_t t = 0; t < direction.column.times(); ++t) {
    if (direction.column.has(t)) {
      append(heading, direction.column.time[t].centre(),
             vector_to_direction(1, direction.column.value[t]), direction.column.source[t]);
    }
  }
  const auto stored_at = [&](UtcTime time) -> std::optional<SeaState> {
    const auto stored = at(height, time);
    if (!stored) return std::nullopt;
    const auto toward = value_at(heading, time, widest_wave_gap);
    return SeaState{*stored, at(period, time).value_or(unknown),
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
