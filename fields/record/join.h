#pragma once
#include <algorithm>
#include <optional>
#include <vector>

#include "fields/record/cadence.h"
#include "fields/record/product_run.h"

namespace slackwater {

/// The values of one run that became part of a series: `count` from `first` on.
template <typename T>
struct Part {
  const ProductRun<T>* run = nullptr;
  std::size_t rank = 0;  ///< smaller counts before larger
  std::size_t first = 0;
  std::size_t count = 0;

  [[nodiscard]] UtcTime from() const { return run->values[first].cell.centre(); }
  [[nodiscard]] UtcTime to() const { return run->values[first + count - 1].cell.centre(); }
};

/// What a run says of a time and level itself: on the line between its values; at most half a day
/// beyond them its first or last.
template <typename T>
[[nodiscard]] std::optional<T> said_at(const ProductRun<T>& run, UtcTime time, std::size_t k) {
  constexpr Duration beyond = std::chrono::hours(12);
  const auto after = std::lower_bound(
      run.values.begin(), run.values.end(), time,
      [](const RunValue<T>& value, UtcTime wanted) { return value.cell.centre() < wanted; });
  const auto value = [&](auto at) -> std::optional<T> {
    const Column<T>& column = at->piece->column;
    if (!column.has(at->t, k)) return std::nullopt;
    return column.value[column.offset(at->t, k)];
  };
  if (after == run.values.end())
    return time - std::prev(after)->cell.centre() <= beyond ? value(std::prev(after))
                                                            : std::nullopt;
  if (after->cell.centre() == time) return value(after);
  if (after == run.values.begin())
    return after->cell.centre() - time <= beyond ? value(after) : std::nullopt;
  const auto before = std::prev(after);
  const auto low = value(before);
  const auto high = value(after);
  if (!low || !high) return std::nullopt;
  const double share = hours_between(before->cell.centre(), time) /
                       hours_between(before->cell.centre(), after->cell.centre());
  return (1 - share) * *low + share * *high;
}

/// A series of parts, each moved at its ends onto the neighbours of higher rank: by the difference
/// there, fading linearly over the ramp, or over the part where that is shorter.
/// @param series  times x levels, ascending: the parts one after the other
template <typename T>
void join_parts(Column<T>& series, const std::vector<Part<T>>& parts, Duration ramp) {
  std::vector<std::size_t> start(parts.size() + 1, 0);
  for (std::size_t p = 0; p < parts.size(); ++p) start[p + 1] = start[p] + parts[p].count;
  std::vector<std::size_t> order(parts.size());
  for (std::size_t p = 0; p < parts.size(); ++p) order[p] = p;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return parts[a].rank < parts[b].rank; });
  const auto ranks_above = [&](std::size_t p, std::size_t other) {
    return parts[other].rank < parts[p].rank;
  };
  for (const std::size_t p : order) {
    const bool before = p > 0 && ranks_above(p, p - 1);
    const bool after = p + 1 < parts.size() && ranks_above(p, p + 1);
    if (!before && !after) continue;
    const UtcTime begin = before ? parts[p - 1].to() : parts[p].from();
    const UtcTime end = after ? parts[p + 1].from() : parts[p].to();
    const Duration reach = before && after ? std::min(ramp, end - begin) : ramp;
    if (reach <= Duration(0)) continue;
    for (std::size_t k = 0; k < series.levels(); ++k) {
      const auto offset_at = [&](std::size_t t, UtcTime join) -> T {
        const auto own = said_at(*parts[p].run, join, k);
        if (!own || !series.has(t, k)) return T{};
        return series.value[series.offset(t, k)] - *own;
      };
      const T onto_before = before ? offset_at(start[p] - 1, begin) : T{};
      const T onto_after = after ? offset_at(start[p + 1], end) : T{};
      for (std::size_t t = start[p]; t < start[p + 1]; ++t) {
        const UtcTime time = series.time[t].centre();
        const auto share = [&](Duration away) {
          return std::max(
              0.0, 1.0 - static_cast<double>(away.count()) / static_cast<double>(reach.count()));
        };
        T& value = series.value[series.offset(t, k)];
        value += share(time - begin) * onto_before;
        value += share(end - time) * onto_after;
      }
    }
  }
}

}  // namespace slackwater
