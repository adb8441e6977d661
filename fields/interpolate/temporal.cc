#include "fields/interpolate/temporal.h"

#include <algorithm>

namespace slackwater {
namespace {

template <typename T>
std::optional<T> linear_at(const Column<T>& series, UtcTime time, Duration widest_gap) {
  const auto above =
      std::lower_bound(series.time.begin(), series.time.end(), time,
                       [](const TimeCell& cell, UtcTime t) { return cell.centre() < t; });
  auto high = static_cast<std::size_t>(above - series.time.begin());
  while (high < series.times() && !series.has(high)) ++high;
  if (high < series.times() && series.time[high].centre() == time)
    return series.value[series.offset(high, 0)];
  auto low = static_cast<std::size_t>(above - series.time.begin());
  while (low > 0 && !series.has(low - 1)) --low;
  if (low == 0 || high >= series.times()) return std::nullopt;
  --low;
  const UtcTime from = series.time[low].centre();
  const UtcTime to = series.time[high].centre();
  if (to - from > widest_gap) return std::nullopt;
  const double share = seconds_between(from, time) / seconds_between(from, to);
  return (1 - share) * series.value[series.offset(low, 0)] +
         share * series.value[series.offset(high, 0)];
}

}  // namespace

std::optional<Horizontal> value_at(const VectorColumn& series, UtcTime time, Duration widest_gap) {
  return linear_at(series, time, widest_gap);
}
std::optional<double> value_at(const ScalarColumn& series, UtcTime time, Duration widest_gap) {
  return linear_at(series, time, widest_gap);
}

std::optional<TimePlace> place_in(std::span<const UtcTime> stamps, UtcTime time) noexcept {
  if (stamps.empty() || time < stamps.front() || time > stamps.back()) return std::nullopt;
  if (stamps.size() == 1) return TimePlace{};
  const auto above = std::upper_bound(stamps.begin(), stamps.end() - 1, time);
  const auto low = static_cast<std::size_t>(above - stamps.begin()) - 1;
  return TimePlace{
      low, seconds_between(stamps[low], time) / seconds_between(stamps[low], stamps[low + 1])};
}

std::optional<Horizontal> mean_over(std::span<const UtcTime> stamps,
                                    std::span<const Horizontal> values, std::size_t stride,
                                    std::size_t offset, const TimeCell& cell) {
  const auto first = place_in(stamps, cell.start);
  const auto last = place_in(stamps, cell.end);
  if (!first || !last) return std::nullopt;
  const auto at = [&](const TimePlace& place) {
    const Horizontal low = values[place.low * stride + offset];
    if (place.upper == 0) return low;
    return (1 - place.upper) * low + place.upper * values[(place.low + 1) * stride + offset];
  };
  if (!cell.is_mean()) return at(*first);
  // Trapezoids between the cell's ends and the stamps inside it.
  Horizontal sum{};
  UtcTime before = cell.start;
  Horizontal value_before = at(*first);
  for (std::size_t t = first->low + 1; t < stamps.size() && stamps[t] < cell.end; ++t) {
    const Horizontal value = values[t * stride + offset];
    sum += 0.5 * (value_before + value) * seconds_between(before, stamps[t]);
    before = stamps[t];
    value_before = value;
  }
  sum += 0.5 * (value_before + at(*last)) * seconds_between(before, cell.end);
  return sum / seconds_between(cell.start, cell.end);
}

}  // namespace slackwater
