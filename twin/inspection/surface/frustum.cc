#include "twin/inspection/surface/frustum.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"

namespace slackwater::twin {
namespace {

constexpr double turn = 2 * constants::pi;
constexpr double least_columns = 8;   // all round: a patch faces one way
constexpr double least_corners = 36;  // all round

std::size_t columns_in(double arc_rad, double radius_m, double patch_m) {
  return std::max(pieces_in(arc_rad * radius_m, patch_m),
                  pieces_in(least_columns * arc_rad / turn, 1));
}

}  // namespace

double Frustum::slant_m() const noexcept {
  return std::hypot(bottom_m - top_m, bottom_radius_m - top_radius_m);
}

void add_frustum(SurfaceBuilder& builder, const Frustum& frustum, const Arc& arc, double patch_m,
                 double left_m, double top_m) {
  const double widest_m = std::max(frustum.top_radius_m, frustum.bottom_radius_m);
  const std::size_t seen = columns_in(arc.arc_rad, widest_m, patch_m);
  const double rest_rad = turn - arc.arc_rad;
  const double column_rad = arc.arc_rad / static_cast<double>(seen);
  PatchedGrid grid;
  grid.across = odd_from(least_corners * column_rad / turn);
  const std::size_t unseen = arc.is_all_round() ? 0 : pieces_in(rest_rad, column_rad);
  grid.columns = seen + unseen;
  grid.rows = pieces_in(frustum.slant_m(), patch_m);
  grid.wraps = true;
  const double rows = static_cast<double>(grid.rows);
  const double row_m = frustum.slant_m() / rows;
  const auto radius_m = [&](double row) {
    return frustum.top_radius_m + (frustum.bottom_radius_m - frustum.top_radius_m) * row / rows;
  };
  grid.at = [&](double column, double row) -> Triple<double> {
    const double past = column - static_cast<double>(seen);
    const double bearing =
        arc.from_rad + (past <= 0 ? column * column_rad
                                  : arc.arc_rad + rest_rad * past / static_cast<double>(unseen));
    return {frustum.north_m + radius_m(row) * std::cos(bearing),
            frustum.east_m + radius_m(row) * std::sin(bearing),
            frustum.top_m + (frustum.bottom_m - frustum.top_m) * row / rows};
  };
  grid.sheet = [&](std::size_t column, std::size_t row) -> std::optional<SheetCell> {
    if (column >= seen) return std::nullopt;
    const double middle = static_cast<double>(row) + 0.5;
    const double round_rad = (static_cast<double>(column) + 0.5) * column_rad;
    return SheetCell{
        left_m + 0.5 * arc.arc_rad * widest_m + (round_rad - 0.5 * arc.arc_rad) * radius_m(middle),
        top_m + middle * row_m, column_rad * radius_m(middle), row_m};
  };
  close_ends(builder, add_grid(builder, grid));
}

Sheet sheet_of(const Frustum& frustum, const Arc& arc) {
  Sheet sheet;
  const double widest_m = std::max(frustum.top_radius_m, frustum.bottom_radius_m);
  sheet.width_m = arc.arc_rad * widest_m;
  sheet.height_m = frustum.slant_m();
  sheet.is_all_round = arc.is_all_round();
  const double first_deg = arc.from_rad * 360 / turn;
  sheet.along = std::abs(std::remainder(first_deg, 360)) < 1e-9
                    ? std::string("clockwise from north")
                    : formatted("clockwise from {:g} deg", first_deg);
  sheet.down = "downwards";
  sheet.first_bearing_rad = arc.from_rad;
  sheet.top_z_m = frustum.top_m;
  return sheet;
}

}  // namespace slackwater::twin
