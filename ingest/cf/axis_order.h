#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "fields/geo/geo_point.h"

namespace slackwater::ingest {

/// One axis put in canonical order, and where each of its places lies in the file.
struct AxisOrder {
  std::vector<double> values;       ///< ascending
  std::vector<std::size_t> source;  ///< index in the file of each value

  /// A stretch of the axis that is contiguous in the file, forward or backward.
  struct Run {
    std::size_t first = 0;  ///< canonical index
    std::size_t count = 0;
    std::size_t source_first = 0;  ///< smallest index in the file
    bool reversed = false;
  };
  /// The stretches that make up places [first, first + count).
  [[nodiscard]] std::vector<Run> runs(std::size_t first, std::size_t count) const;
};

/// Depths or heights, metres; any order in the file, but no two alike. Throws Error(invalid_input).
[[nodiscard]] AxisOrder level_axis(const std::vector<double>& levels_m);

/// Latitudes, degrees, rising or falling; cut to the cells inside the box and one around.
/// Throws Error(invalid_input) for values that are not finite, beyond the poles or not monotonic,
/// and where the cut selects nothing (with the file's extent).
[[nodiscard]] AxisOrder latitude_axis(const std::vector<double>& latitudes_deg,
                                      const std::optional<BoundingBox>& cut);

/// Longitudes, degrees, in any convention (0...360, -180...180, across the antimeridian), made
/// continuous with the first one in [-180, 180). A grid around the globe is turned so that it
/// starts just west of the cut, else at -180.
[[nodiscard]] AxisOrder longitude_axis(const std::vector<double>& longitudes_deg,
                                       const std::optional<BoundingBox>& cut);

}  // namespace slackwater::ingest
