#include "twin/inspection/surface/patched_grid.h"

#include <algorithm>
#include <utility>

namespace slackwater::twin {
namespace {

/// How far a patch's centre is off the diagonal of its middle quadrilateral, towards the middle of
/// a triangle: on the edge between two triangles a ray might pass between them by rounding.
constexpr double off_the_diagonal = 0.1;

GridEdges add(SurfaceBuilder& builder, const PatchedGrid& grid, bool is_ring) {
  const std::size_t columns = grid.columns * grid.across, rows = grid.rows * grid.high;
  builder.expect_room(grid.sheet ? grid.columns * grid.rows : 0, 2 * columns * rows);
  const std::size_t across = columns + (grid.wraps ? 0 : 1);
  std::vector<std::uint32_t> corners;
  corners.reserve(across * (rows + 1));
  const std::size_t levels = rows + (is_ring ? 0 : 1);
  for (std::size_t j = 0; j < levels; ++j)
    for (std::size_t i = 0; i < across; ++i)
      corners.push_back(
          builder.add_corner(grid.at(static_cast<double>(i) / static_cast<double>(grid.across),
                                     static_cast<double>(j) / static_cast<double>(grid.high))));
  const auto corner = [&](std::size_t i, std::size_t j) {
    return corners[(j == levels ? 0 : j) * across + (i == across ? 0 : i)];
  };
  for (std::size_t row = 0; row < grid.rows; ++row)
    for (std::size_t column = 0; column < grid.columns; ++column) {
      const auto cell = grid.sheet ? grid.sheet(column, row) : std::nullopt;
      std::uint32_t patch = no_patch;
      const std::size_t i0 = column * grid.across, j0 = row * grid.high;
      if (cell) {
        // The centre is a little to the right of the middle, and above it.
        const double aside = off_the_diagonal / 6;
        patch = builder.add_patch(
            cell->along_m + aside * cell->width_m / static_cast<double>(grid.across),
            cell->down_m - aside * cell->height_m / static_cast<double>(grid.high), cell->width_m,
            cell->height_m);
        const std::size_t i = i0 + grid.across / 2, j = j0 + grid.high / 2;
        const double end = (1 - off_the_diagonal) / 2 + off_the_diagonal / 3;
        builder.put_centre(patch, {corner(i, j), corner(i + 1, j), corner(i + 1, j + 1)},
                           {end, off_the_diagonal / 3, end});
      }
      for (std::size_t j = j0; j < j0 + grid.high; ++j)
        for (std::size_t i = i0; i < i0 + grid.across; ++i) {
          const std::uint32_t a = corner(i, j), c = corner(i + 1, j + 1);
          std::uint32_t b = corner(i + 1, j), d = corner(i, j + 1);
          if (!grid.is_from_within) std::swap(b, d);
          builder.add_triangle(a, b, c, patch);
          builder.add_triangle(a, c, d, patch);
        }
    }
  using Difference = std::ptrdiff_t;
  return {{corners.begin(), corners.begin() + static_cast<Difference>(across)},
          {corners.end() - static_cast<Difference>(across), corners.end()}};
}

}  // namespace

GridEdges add_grid(SurfaceBuilder& builder, const PatchedGrid& grid) {
  return add(builder, grid, false);
}

void add_closed_ring(SurfaceBuilder& builder, const PatchedGrid& grid) {
  (void)add(builder, grid, true);
}

void close_ends(SurfaceBuilder& builder, GridEdges edges) {
  // The grid goes along its upper edge to the right, and its cap the other way.
  std::reverse(edges.top.begin(), edges.top.end());
  builder.add_cap(edges.top);
  builder.add_cap(edges.bottom);
}

}  // namespace slackwater::twin
