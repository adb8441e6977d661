#pragma once
#include <array>
#include <cstddef>
#include <optional>

#include "fields/geo/geo_point.h"
#include "fields/grid/gridded_field.h"

namespace slackwater {

/// The cells around a point and their bilinear weights. Weights sum to one; cells of weight zero
/// are left out.
struct HorizontalStencil {
  struct Corner {
    std::size_t row = 0;
    std::size_t column = 0;
    double weight = 0;
  };
  std::array<Corner, 4> corners{};
  std::size_t count = 0;
};

/// Bilinear stencil of a point, or nothing where the point lies more than half a cell (5 km for a
/// lone cell) beyond the outermost cell centres. Between a centre and that edge the outermost
/// cell's value holds.
[[nodiscard]] std::optional<HorizontalStencil> bilinear_stencil(const Grid& grid,
                                                                const GeoPoint& point);

/// The longitude of a point expressed in the continuous range of a grid's axis (adds or takes 360
/// degrees).
[[nodiscard]] double longitude_on_axis_deg(const Grid& grid, const GeoPoint& point);

}  // namespace slackwater
