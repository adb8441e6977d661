#include "fields/interpolate/stencil.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/constants.h"

namespace slackwater {
namespace {

/// A place on an axis: between `low` and `low + 1`, the share `upper` of the way.
struct AxisPlace {
  std::size_t low = 0;
  double upper = 0;
};

/// Coordinates read from float files miss the cell centre by up to 1e-5 degrees; within this share
/// of a cell the point is the centre, so that a column at a cell is exactly that cell.
constexpr double centre_tolerance = 1e-3;

std::optional<AxisPlace> place_on(const std::vector<double>& axis, double value,
                                  double lone_half_cell) {
  const std::size_t n = axis.size();
  if (n == 1) {
    if (std::abs(value - axis[0]) > lone_half_cell) return std::nullopt;
    return AxisPlace{};
  }
  const double before = 0.5 * (axis[1] - axis[0]);
  const double after = 0.5 * (axis[n - 1] - axis[n - 2]);
  // The edge itself belongs to the grid; 1e-9 of a cell forgives the rounding of the edge.
  if (value < axis.front() - before * (1 + 1e-9) || value > axis.back() + after * (1 + 1e-9)) {
    return std::nullopt;
  }
  if (value <= axis.front()) return AxisPlace{};
  if (value >= axis.back()) return AxisPlace{n - 2, 1.0};
  const auto above = std::upper_bound(axis.begin(), axis.end(), value);
  const auto low = static_cast<std::size_t>(above - axis.begin()) - 1;
  double upper = (value - axis[low]) / (axis[low + 1] - axis[low]);
  if (upper < centre_tolerance) upper = 0;
  if (upper > 1 - centre_tolerance) upper = 1;
  return AxisPlace{low, upper};
}

/// Half a lone cell in degrees of latitude: 5 km (fields/docs/conventions.md).
double lone_half_cell_deg() { return 5000.0 / (constants::earth_radius_m * constants::pi / 180.0); }

}  // namespace

double longitude_on_axis_deg(const Grid& grid, const GeoPoint& point) {
  const double middle = 0.5 * (grid.longitude_deg.front() + grid.longitude_deg.back());
  double longitude = point.longitude_deg();
  longitude += 360.0 * std::round((middle - longitude) / 360.0);
  return longitude;
}

std::optional<HorizontalStencil> bilinear_stencil(const Grid& grid, const GeoPoint& point) {
  const double cosine = std::max(0.01, std::cos(point.latitude.radians()));
  const auto row = place_on(grid.latitude_deg, point.latitude_deg(), lone_half_cell_deg());
  const auto column = place_on(grid.longitude_deg, longitude_on_axis_deg(grid, point),
                               lone_half_cell_deg() / cosine);
  if (!row || !column) return std::nullopt;
  HorizontalStencil stencil;
  for (const std::size_t j : {0, 1}) {
    for (const std::size_t i : {0, 1}) {
      const double weight =
          (j == 0 ? 1 - row->upper : row->upper) * (i == 0 ? 1 - column->upper : column->upper);
      if (weight > 0) stencil.corners[stencil.count++] = {row->low + j, column->low + i, weight};
    }
  }
  return stencil;
}

}  // namespace slackwater
