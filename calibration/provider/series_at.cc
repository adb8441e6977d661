#include "calibration/provider/series_at.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "fields/base/numbers/statistics.h"
#include "fields/interpolate/temporal.h"

namespace slackwater::calibration {
namespace {

constexpr double reach_m = 2.0;
constexpr Duration least_gap = std::chrono::hours(12);
constexpr Duration longest_to_its_edges = std::chrono::hours(3);

/// Where a depth lies among levels, which may come in any order.
struct DepthPlace {
  std::size_t low = 0;
  std::size_t high = 0;
  double share = 0;
};

std::optional<DepthPlace> depth_place(const VectorColumn& series, double depth_m) {
  if (series.levels_m.empty()) return DepthPlace{};
  std::optional<std::size_t> above;
  std::optional<std::size_t> below;
  for (std::size_t k = 0; k < series.levels(); ++k) {
    const double level = series.levels_m[k];
    if (level <= depth_m && (!above || level > series.levels_m[*above])) above = k;
    if (level >= depth_m && (!below || level < series.levels_m[*below])) below = k;
  }
  if (above && below) {
    const double thickness = series.levels_m[*below] - series.levels_m[*above];
    const double share = thickness > 0 ? (depth_m - series.levels_m[*above]) / thickness : 0;
    return DepthPlace{*above, *below, share};
  }
  const std::size_t nearest = above ? *above : *below;
  if (std::abs(series.levels_m[nearest] - depth_m) > reach_m) return std::nullopt;
  return DepthPlace{nearest, nearest, 0};
}

std::optional<Horizontal> value_of(const VectorColumn& series, std::size_t t,
                                   const DepthPlace& place) {
  if (!series.has(t, place.low) || !series.has(t, place.high)) return std::nullopt;
  return (1 - place.share) * series.value[series.offset(t, place.low)] +
         place.share * series.value[series.offset(t, place.high)];
}

/// The usual step, from the middle one of the steps.
Duration usual_step(const VectorColumn& series) {
  std::vector<Duration> steps;
  for (std::size_t t = 1; t < series.times(); ++t)
    steps.push_back(series.time[t].centre() - series.time[t - 1].centre());
  if (steps.empty()) return Duration(0);
  return upper_median(std::move(steps));
}

/// The line of one depth, and the cells that it goes through.
struct Line {
  std::vector<UtcTime> at;
  std::vector<Horizontal> value;  ///< without the tide
  std::vector<TimeCell> cell;     ///< of the series, with
  std::vector<Horizontal> whole;  ///< their values, tide as in the series
};

Horizontal tide_of(const TideBetween& between, std::size_t level, const TimeCell& cell) {
  return between.tide == nullptr ? Horizontal{} : between.tide->at(level, cell);
}

Line line_of(const VectorColumn& series, const TideBetween& between, std::size_t level,
             const DepthPlace& place) {
  Line line;
  for (std::size_t t = 0; t < series.times(); ++t) {
    const auto value = value_of(series, t, place);
    if (!value) continue;
    const TimeCell& cell = series.time[t];
    const Horizontal rest = between.is_in_series ? *value - tide_of(between, level, cell) : *value;
    const bool reaches_its_edges = cell.end - cell.start <= longest_to_its_edges;
    if (line.at.empty() && reaches_its_edges && cell.start < cell.centre()) {
      line.at.push_back(cell.start);
      line.value.push_back(rest);
    }
    line.at.push_back(cell.centre());
    line.value.push_back(rest);
    line.cell.push_back(cell);
    line.whole.push_back(*value);
  }
  if (line.cell.empty()) return line;
  const TimeCell& last = line.cell.back();
  if (last.end > last.centre() && last.end - last.start <= longest_to_its_edges) {
    line.at.push_back(last.end);
    line.value.push_back(line.value.back());
  }
  return line;
}

/// Whether the line has no gap from the first to the last moment of a cell.
bool is_whole_over(const Line& line, const TimeCell& cell, Duration widest_gap) {
  const auto first = std::upper_bound(line.at.begin(), line.at.end(), cell.start);
  const auto last = std::lower_bound(line.at.begin(), line.at.end(), cell.end);
  for (auto at = first; at != line.at.end() && at <= last; ++at) {
    if (*at - *std::prev(at) > widest_gap) return false;
  }
  return true;
}

}  // namespace

BaselineForecast series_at(const VectorColumn& series, const TideBetween& between,
                           std::span<const TimeCell> cells, std::span<const double> depth_m) {
  BaselineForecast made;
  made.value.resize(cells.size() * depth_m.size());
  made.status.resize(made.value.size(), SampleStatus::missing);
  const Duration widest_gap = std::max(least_gap, usual_step(series) * 5 / 4);
  for (std::size_t k = 0; k < depth_m.size(); ++k) {
    const auto place = depth_place(series, depth_m[k]);
    if (!place) continue;
    const Line line = line_of(series, between, k, *place);
    for (std::size_t t = 0; t < cells.size(); ++t) {
      const std::size_t o = t * depth_m.size() + k;
      const auto same = std::lower_bound(
          line.cell.begin(), line.cell.end(), cells[t],
          [](const TimeCell& a, const TimeCell& b) { return a.centre() < b.centre(); });
      if (same != line.cell.end() && *same == cells[t]) {
        made.value[o] = line.whole[static_cast<std::size_t>(same - line.cell.begin())];
        if (!between.is_in_series) made.value[o] += tide_of(between, k, cells[t]);
      } else {
        const auto rest = mean_over(line.at, line.value, 1, 0, cells[t]);
        if (!rest || !is_whole_over(line, cells[t], widest_gap)) continue;
        made.value[o] = *rest + tide_of(between, k, cells[t]);
      }
      made.status[o] = SampleStatus::ok;
    }
  }
  return made;
}

}  // namespace slackwater::calibration
