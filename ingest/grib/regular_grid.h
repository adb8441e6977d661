#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "fields/geo/geo_point.h"
#include "ingest/grib/message.h"

namespace slackwater::ingest::grib {

/// The canonical axes of a regular latitude-longitude field and where each of its points stands in
/// the message.
///
/// The order of the axes and the cut are those of ingest/cf/axis_order.h.
struct RegularGrid {
  std::vector<double> latitude_deg;
  std::vector<double> longitude_deg;
  std::vector<std::size_t> source_row;     ///< scan row of each latitude
  std::vector<std::size_t> source_column;  ///< scan column of each longitude
  std::size_t ni = 0;                      ///< points along a parallel in the message
  std::size_t nj = 0;                      ///< points along a meridian in the message
  bool columns_first = false;              ///< adjacent values are consecutive along a meridian
  bool alternating = false;                ///< every other scan line runs backwards

  /// Position in the message's values of (row, column) of the canonical grid.
  [[nodiscard]] std::size_t source(std::size_t row, std::size_t column) const noexcept {
    const std::size_t j = source_row[row];
    const std::size_t i = source_column[column];
    if (columns_first) return i * nj + (alternating && i % 2 == 1 ? nj - 1 - j : j);
    return j * ni + (alternating && j % 2 == 1 ? ni - 1 - i : i);
  }
  bool operator==(const RegularGrid&) const = default;
};

/// Reads the grid of a message and keeps the cells inside `cut` with one cell around it.
/// Throws Error(invalid_input): a grid that is not regular in latitude and longitude (what it is,
/// and how to regrid it), a grid beyond the poles or with no cell in the cut, one of more than 8
/// million points.
[[nodiscard]] RegularGrid regular_grid_of(const Message& message,
                                          const std::optional<BoundingBox>& cut);

}  // namespace slackwater::ingest::grib
