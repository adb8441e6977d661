#pragma once
#include <cstddef>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/gridded_field.h"
#include "fields/grid/status.h"

namespace slackwater {

/// The time x level series of one quantity at one place, with a status per value.
/// T is double for a scalar, `Horizontal` (east + i north) for a vector.
template <typename T>
struct Column {
  GeoPoint point;
  std::vector<TimeCell> time;  ///< ascending
  VerticalKind vertical = VerticalKind::none;
  std::vector<double> levels_m;  ///< empty means one level
  std::vector<T> value;  ///< times x levels, level fastest; meaningless where !has_value(status)
  std::vector<SampleStatus> status;  ///< times x levels
  std::vector<DataStatus> source;    ///< per time

  [[nodiscard]] std::size_t times() const noexcept { return time.size(); }
  [[nodiscard]] std::size_t levels() const noexcept {
    return levels_m.empty() ? 1 : levels_m.size();
  }
  [[nodiscard]] std::size_t offset(std::size_t t, std::size_t k) const noexcept {
    return t * levels() + k;
  }
  [[nodiscard]] bool has(std::size_t t, std::size_t k = 0) const noexcept {
    return has_value(status[offset(t, k)]);
  }
};

using VectorColumn = Column<Horizontal>;  ///< current (levels = depth), wind (one level)
using ScalarColumn = Column<double>;

}  // namespace slackwater
