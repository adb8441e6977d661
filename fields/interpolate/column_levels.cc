#include "fields/interpolate/column_levels.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fields/interpolate/temporal.h"

namespace slackwater {
namespace {

constexpr double same_level_m = 1e-3;

/// Neighbouring levels of a depth and the share of the lower one; equal ones at or beside a level.
struct LevelPlace {
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0;
};

std::optional<LevelPlace> place_of(const std::vector<double>& levels, double depth_m) {
  for (std::size_t k = 0; k < levels.size(); ++k)
    if (std::abs(levels[k] - depth_m) <= same_level_m) return LevelPlace{k, k, 0};
  const auto above = std::upper_bound(levels.begin(), levels.end(), depth_m);
  if (above == levels.begin() || above == levels.end()) return std::nullopt;
  const auto high = static_cast<std::size_t>(above - levels.begin());
  return LevelPlace{high - 1, high,
                    (depth_m - levels[high - 1]) / (levels[high] - levels[high - 1])};
}

VectorColumn one_level(const VectorColumn& column, std::size_t k) {
  VectorColumn level;
  level.time = column.time;
  for (std::size_t t = 0; t < column.times(); ++t) {
    level.value.push_back(column.value[column.offset(t, k)]);
    level.status.push_back(column.status[column.offset(t, k)]);
  }
  return level;
}

/// The mean whose interval holds a time: what is known of it after the last centre.
std::optional<Horizontal> mean_around(const VectorColumn& level, UtcTime time) {
  for (std::size_t t = 0; t < level.times(); ++t) {
    if (level.has(t) && level.time[t].start <= time && time <= level.time[t].end)
      return level.value[t];
  }
  return std::nullopt;
}

}  // namespace

VectorColumn at_depths(const VectorColumn& column, const std::vector<double>& depths_m) {
  VectorColumn out;
  out.point = column.point;
  out.time = column.time;
  out.source = column.source;
  out.vertical = VerticalKind::depth_m;
  out.levels_m = depths_m;
  out.value.assign(column.times() * depths_m.size(), {});
  out.status.assign(column.times() * depths_m.size(), SampleStatus::missing);
  for (std::size_t k = 0; k < depths_m.size(); ++k) {
    const auto place = place_of(column.levels_m, depths_m[k]);
    if (!place) continue;
    for (std::size_t t = 0; t < column.times(); ++t) {
      if (!column.has(t, place->low) || !column.has(t, place->high)) continue;
      out.value[out.offset(t, k)] =
          (1 - place->share) * column.value[column.offset(t, place->low)] +
          place->share * column.value[column.offset(t, place->high)];
      out.status[out.offset(t, k)] = column.status[column.offset(t, place->low)];
    }
  }
  return out;
}

VectorColumn at_times(const VectorColumn& column, const std::vector<TimeCell>& times,
                      Duration widest_gap) {
  VectorColumn out;
  out.point = column.point;
  out.time = times;
  out.source.assign(times.size(),
                    column.source.empty() ? DataStatus::analysis : column.source.front());
  out.vertical = column.vertical;
  out.levels_m = column.levels_m;
  out.value.assign(times.size() * column.levels(), {});
  out.status.assign(times.size() * column.levels(), SampleStatus::missing);
  for (std::size_t k = 0; k < column.levels(); ++k) {
    const VectorColumn level = one_level(column, k);
    for (std::size_t t = 0; t < times.size(); ++t) {
      auto value = value_at(level, times[t].centre(), widest_gap);
      if (!value) value = mean_around(level, times[t].centre());
      if (!value) continue;
      out.value[out.offset(t, k)] = *value;
      out.status[out.offset(t, k)] = SampleStatus::ok;
    }
  }
  return out;
}

}  // namespace slackwater
