#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "fields/geo/geo_point.h"

namespace slackwater {

/// The columns that speak for a place, and how loudly. Weights are positive and sum to one.
struct ColumnStencil {
  std::array<std::uint32_t, 4> column{};
  std::array<double, 4> weight{};
  std::uint32_t count = 0;
  bool is_inside = false;  ///< the place lies in the area at all; count 0 there: on land
};

/// How the columns of a forecast lie, and who speaks between them.
///
/// Columns on the crossings of a grid (most of them there; the others are land): bilinear among the
/// columns around, those on land left out. A place up to half a cell beyond the outermost centres
/// is inside; for one column alone, or one row, half a cell is 5 km (fields/docs/conventions.md).
/// Columns anywhere: the four nearest, weighted by (1/d - 1/R)^2 with R the distance of the fifth
/// (Franke and Little, in Barnhill 1977), which is continuous where neighbours change; up to 5 km
/// from the nearest.
class ColumnLayout {
 public:
  ColumnLayout() = default;
  explicit ColumnLayout(std::span<const GeoPoint> columns);

  /// Some 10 ns on a grid. No allocation, thread-safe.
  [[nodiscard]] ColumnStencil at(double longitude_deg, double latitude_deg) const noexcept;
  [[nodiscard]] bool is_grid() const noexcept { return is_grid_; }
  /// Of all that is inside.
  [[nodiscard]] const BoundingBox& box() const noexcept { return box_; }

 private:
  void lay_cells();
  [[nodiscard]] ColumnStencil at_scattered(double x, double y) const noexcept;

  /// One axis of a grid; centres grow.
  struct Axis {
    std::vector<double> centre;
    double reach_low = 0;   ///< half a cell beyond the first
    double reach_high = 0;  ///< and the last
    double per_span = 0;    ///< cells per degree, were they even
    std::vector<double> per_step;
    struct Place {
      std::size_t low = 0;
      double upper = 0;
      bool is_inside = false;
    };
    [[nodiscard]] Place at(double value) const noexcept;
  };

  double origin_deg_ = 0;  ///< longitudes are counted from here, so that no grid is cut by 180 E
  bool is_grid_ = false;
  Axis x_;
  Axis y_;
  std::vector<std::uint32_t> column_;  ///< rows x columns of the grid; `none` on land
  /// Of each cell of the grid, its corners; `none` first where one of them is on land.
  std::vector<std::array<std::uint32_t, 4>> cell_;
  struct Point {
    double x = 0;  ///< metres east of the origin, on the sphere
    double y = 0;
  };
  std::vector<Point> point_;  ///< of scattered columns
  double metres_per_degree_east_ = 0;
  BoundingBox box_;
};

}  // namespace slackwater
