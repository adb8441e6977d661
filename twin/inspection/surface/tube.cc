#include "twin/inspection/surface/tube.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

constexpr double turn = 2 * constants::pi;

/// Two unit vectors across a direction: up where that is not its way, and to its right-handed side.
struct Across {
  Triple<double> first;
  Triple<double> second;
};
Across across_of(const Triple<double>& way) {
  // Of an upright one from north; else from above.
  const Triple<double> aim =
      std::hypot(way.x, way.y) < 1e-6 ? Triple<double>{1, 0, 0} : Triple<double>{0, 0, -1};
  const Triple<double> off = aim - dot(aim, way) * way;
  const Triple<double> first = (1 / length_of(off)) * off;
  return {first, cross(way, first)};
}

}  // namespace

void add_tube(SurfaceBuilder& builder, const Tube& tube, double patch_m,
              const std::optional<TubeSheet>& sheet) {
  constexpr std::size_t least_columns = 8;
  const Triple<double> along = tube.to_m - tube.from_m;
  const double length_m = length_of(along);
  const Across across = across_of((1 / length_m) * along);
  const double girth_m = turn * tube.radius_m;
  PatchedGrid grid;
  grid.columns = std::max(pieces_in(girth_m, patch_m), least_columns);
  grid.rows = sheet ? pieces_in(length_m, patch_m) : 1;
  grid.wraps = true;
  const double columns = static_cast<double>(grid.columns), rows = static_cast<double>(grid.rows);
  grid.at = [&](double column, double row) {
    const double angle = turn * column / columns;
    return tube.from_m + (row / rows) * along +
           tube.radius_m * (std::cos(angle) * across.first + std::sin(angle) * across.second);
  };
  if (sheet)
    grid.sheet = [&](std::size_t column, std::size_t row) -> std::optional<SheetCell> {
      const double round_m = (static_cast<double>(column) + 0.5) * girth_m / columns;
      const double down_m = (static_cast<double>(row) + 0.5) * length_m / rows;
      if (sheet->lies)
        return SheetCell{sheet->left_m + down_m, sheet->top_m + round_m, length_m / rows,
                         girth_m / columns};
      return SheetCell{sheet->left_m + round_m, sheet->top_m + down_m, girth_m / columns,
                       length_m / rows};
    };
  close_ends(builder, add_grid(builder, grid));
}

}  // namespace slackwater::twin
