#include "twin/surface/cylinder_patch.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"
#include "fields/base/turn.h"

namespace slackwater::twin {
namespace {

constexpr double turn = 2 * constants::pi;

/// Rounding must not make one cell more of a length that is a multiple of them.
std::size_t cells_in(double length_m, double cell_m) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / cell_m - 1e-6)));
}

}  // namespace

double CylinderPatch::girth_m() const noexcept { return turn * pile.radius_m; }
double CylinderPatch::column_m() const noexcept { return width_m() / static_cast<double>(columns); }
double CylinderPatch::row_m() const noexcept { return height_m() / static_cast<double>(rows); }
bool CylinderPatch::is_all_round() const noexcept { return arc_rad > turn - 1e-9; }

CylinderPatch cut_open(const Cylinder& pile, double from_rad, double arc_rad, double top_m,
                       double bottom_m, double cell_m) {
  expects(arc_rad > 0 && arc_rad <= turn + 1e-9 && bottom_m > top_m && cell_m > 0,
          "a patch has an extent");
  CylinderPatch patch{pile, from_rad, arc_rad, top_m, bottom_m, 0, 0};
  patch.columns = cells_in(patch.width_m(), cell_m);
  patch.rows = cells_in(patch.height_m(), cell_m);
  return patch;
}

FacePlace face_place(const CylinderPatch& patch, const Triple<double>& at_m) noexcept {
  const double north = at_m.x - patch.pile.north_m, east = at_m.y - patch.pile.east_m;
  return {compass_rad(std::atan2(east, north) - patch.from_rad) * patch.pile.radius_m,
          at_m.z - patch.top_m, std::sqrt(north * north + east * east) - patch.pile.radius_m};
}

}  // namespace slackwater::twin
