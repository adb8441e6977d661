#pragma once
#include "fields/interpolate/column.h"

namespace slackwater {

/// The part of a series whose cells lie wholly inside [from, to].
template <typename T>
[[nodiscard]] Column<T> slice(const Column<T>& column, UtcTime from, UtcTime to) {
  Column<T> part;
  part.point = column.point;
  part.vertical = column.vertical;
  part.levels_m = column.levels_m;
  for (std::size_t t = 0; t < column.times(); ++t) {
    if (column.time[t].start < from || column.time[t].end > to) continue;
    part.time.push_back(column.time[t]);
    part.source.push_back(column.source[t]);
    for (std::size_t k = 0; k < column.levels(); ++k) {
      part.value.push_back(column.value[column.offset(t, k)]);
      part.status.push_back(column.status[column.offset(t, k)]);
    }
  }
  return part;
}

/// Adds the cells of one series after those of another on the same levels.
template <typename T>
void append(Column<T>& column, const Column<T>& more) {
  column.time.insert(column.time.end(), more.time.begin(), more.time.end());
  column.value.insert(column.value.end(), more.value.begin(), more.value.end());
  column.status.insert(column.status.end(), more.status.begin(), more.status.end());
  column.source.insert(column.source.end(), more.source.begin(), more.source.end());
}

}  // namespace slackwater
