#pragma once
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/geo/geo_point.h"
#include "fields/grid/status.h"

namespace slackwater {

/// What the vertical coordinate of a field counts.
enum class VerticalKind {
  none,      ///< a surface or depth-independent quantity: `levels_m` is empty, one level
  depth_m,   ///< metres below mean sea level, positive down, ascending
  height_m,  ///< metres above mean sea level (wind), positive up, ascending
};

/// The axes of a rectilinear field, canonical: latitudes and depths/heights ascending; longitudes
/// ascending and continuous (the first one in [-180, 180), so a grid across the antimeridian runs
/// past 180); times ascending and unique, or empty for a static field.
struct Grid {
  std::vector<TimeCell> time;
  VerticalKind vertical = VerticalKind::none;
  std::vector<double> levels_m;
  std::vector<double> latitude_deg;
  std::vector<double> longitude_deg;

  [[nodiscard]] std::size_t times() const noexcept { return time.empty() ? 1 : time.size(); }
  [[nodiscard]] std::size_t levels() const noexcept {
    return levels_m.empty() ? 1 : levels_m.size();
  }
  [[nodiscard]] std::size_t rows() const noexcept { return latitude_deg.size(); }
  [[nodiscard]] std::size_t columns() const noexcept { return longitude_deg.size(); }
  [[nodiscard]] std::size_t size() const noexcept {
    return times() * levels() * rows() * columns();
  }
  /// Position of (time, level, row, column) in a value array: row-major, longitude fastest.
  [[nodiscard]] std::size_t offset(std::size_t t, std::size_t k, std::size_t j,
                                   std::size_t i) const noexcept {
    return ((t * levels() + k) * rows() + j) * columns() + i;
  }
  bool operator==(const Grid&) const = default;
};

/// Throws ContractViolation unless the axes keep the promises of `Grid`.
void expect_canonical(const Grid& grid);

/// One quantity on a grid, in memory, in the SI unit of its CF standard name. NaN where there is no
/// value.
struct GriddedField {
  std::string standard_name;  ///< CF, e.g. "eastward_sea_water_velocity"
  std::string unit;           ///< canonical, e.g. "m s-1", "degree", "K", "m", "1"
  Grid grid;
  std::vector<float> values;  ///< grid.size()
  std::vector<SampleStatus>
      status;  ///< empty for gridded products (NaN = missing); else grid.size()
};

/// The box that the cells of the grid cover: half a cell beyond the outermost centres (5 km for a
/// lone centre).
[[nodiscard]] BoundingBox coverage_of(const Grid& grid);

}  // namespace slackwater
