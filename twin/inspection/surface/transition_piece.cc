#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/block.h"
#include "twin/inspection/surface/frustum.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/tube.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {
namespace {

constexpr double gap_m = 0.5;  // between parts on the sheet

/// Parts below the mantle on the sheet, one row of them below the other.
struct Shelf {
  double left_m = 0;
  double top_m = 0;
  double high_m = 0;
  double widest_m = 0;

  FaceSheet put(double width_m, double height_m) {
    const FaceSheet place{left_m, top_m};
    left_m += width_m + gap_m;
    high_m = std::max(high_m, height_m);
    widest_m = std::max(widest_m, left_m - gap_m);
    return place;
  }
  void next_row() {
    top_m += high_m + gap_m;
    left_m = high_m = 0;
  }
};

/// A place by bearing from the axis, distance from it, and to its right as seen from outside.
struct Landing {
  Triple<double> axis_m;
  Triple<double> out;
  Triple<double> aside;

  Triple<double> at(double out_m, double aside_m, double z_m) const {
    Triple<double> place = axis_m + out_m * out + aside_m * aside;
    place.z = z_m;
    return place;
  }
};

/// Its outer side, top and lower side are patched; the inner one lies on the face.
void add_flange(SurfaceBuilder& builder, const Frustum& piece, double patch_m, Shelf& shelf,
                double width_m, double thickness_m) {
  const double outer_m = piece.top_radius_m + width_m;
  const double around_m = 2 * constants::pi * outer_m;
  PatchedGrid ring;
  ring.columns = std::max<std::size_t>(pieces_in(around_m, patch_m), 36);
  ring.rows = 4;
  ring.wraps = true;
  const double columns = static_cast<double>(ring.columns);
  // Inner upper edge, outer upper, outer lower, inner lower, and up behind it to where it began.
  const std::array<double, 5> radius_m{piece.top_radius_m, outer_m, outer_m, piece.top_radius_m,
                                       piece.top_radius_m};
  const std::array<double, 5> z_m{piece.top_m, piece.top_m, piece.top_m + thickness_m,
                                  piece.top_m + thickness_m, piece.top_m};
  const std::array<double, 4> high_m{width_m, thickness_m, width_m, thickness_m};
  const FaceSheet place = shelf.put(around_m, 2 * width_m + thickness_m);
  const std::array<double, 4> down_m{0.5 * width_m, width_m + 0.5 * thickness_m,
                                     1.5 * width_m + thickness_m, 0};
  ring.at = [&](double column, double row) -> Triple<double> {
    const double bearing = 2 * constants::pi * column / columns;
    const auto r = static_cast<std::size_t>(std::lround(row));
    return {piece.north_m + radius_m[r] * std::cos(bearing),
            piece.east_m + radius_m[r] * std::sin(bearing), z_m[r]};
  };
  ring.sheet = [&](std::size_t column, std::size_t row) -> std::optional<SheetCell> {
    if (row == 3) return std::nullopt;
    return SheetCell{place.left_m + (static_cast<double>(column) + 0.5) * around_m / columns,
                     place.top_m + down_m[row], around_m / columns, high_m[row]};
  };
  add_closed_ring(builder, ring);
}

/// Their heads hang below the flange; the side that faces outward is what is looked at.
void add_bolts(SurfaceBuilder& builder, const Frustum& piece, Shelf& shelf, int bolts,
               double flange_width_m, double flange_thickness_m) {
  const double circle_m = piece.top_radius_m + 0.5 * flange_width_m;
  const Triple<double> size_m{usual::bolt_m, usual::bolt_m, usual::bolt_height_m};
  for (int i = 0; i < bolts; ++i) {
    const double bearing = 2 * constants::pi * (i + 0.5) / bolts;
    const Triple<double> out{std::cos(bearing), std::sin(bearing), 0};
    const Triple<double> right{-out.y, out.x, 0};
    Triple<double> middle_m = Triple<double>{piece.north_m, piece.east_m, 0} + circle_m * out;
    middle_m.z = piece.top_m + flange_thickness_m + 0.5 * size_m.z;
    Block bolt;
    bolt.size_m = size_m;
    bolt.at = box_at(middle_m, out, right, size_m);
    bolt.patch_m = 2 * usual::bolt_height_m;  // one piece
    // At its bearing, below the flange.
    bolt.faces[0] = FaceSheet{bearing * circle_m - 0.5 * size_m.y, shelf.top_m};
    add_block(builder, bolt);
  }
  shelf.high_m = size_m.z;
}

}  // namespace

Surface make(const TransitionPieceSizes& sizes, double patch_m) {
  const Upright& upright = sizes.upright;
  expect_goes_down(upright);
  const double radius_m = sizes.radius_m;
  const Frustum piece{upright.north_m, upright.east_m, radius_m,
                      radius_m,        upright.top_m,  upright.bottom_m};
  const Arc all_round;
  const double height_m = upright.bottom_m - upright.top_m;
  SurfaceBuilder builder({upright.north_m, upright.east_m, upright.top_m});
  add_frustum(builder, piece, all_round, patch_m);
  Sheet sheet = sheet_of(piece, all_round);
  Shelf shelf{0, height_m + gap_m, 0, 0};

  const double width_m = sizes.flange_width_m.value_or(usual::flange_width_m);
  const double thickness_m = sizes.flange_thickness_m.value_or(usual::flange_thickness_m);
  const int bolts = sizes.bolts.value_or(usual::bolts);
  if (bolts * usual::bolt_m > 2 * constants::pi * (radius_m + 0.5 * width_m))
    throw Unmakeable{"bolts", formatted("{} heads of {:g} m do not fit round a flange of {:g} m "
                                        "radius; take fewer",
                                        bolts, usual::bolt_m, radius_m)};
  const double taken_m = thickness_m + usual::bolt_height_m;
  if (height_m < 2 * taken_m)
    throw Unmakeable{"to", formatted("leaves {:g} m of height, and the flange with its bolts takes "
                                     "{:g} m; make it at least twice that",
                                     height_m, taken_m)};
  add_flange(builder, piece, patch_m, shelf, width_m, thickness_m);
  shelf.next_row();
  add_bolts(builder, piece, shelf, bolts, width_m, thickness_m);
  shelf.next_row();

  if (sizes.landing_rad) {
    const double bearing = *sizes.landing_rad;
    const Landing landing{{upright.north_m, upright.east_m, 0},
                          {std::cos(bearing), std::sin(bearing), 0},
                          {std::sin(bearing), -std::cos(bearing), 0}};
    // Below the flange, and to the lower edge.
    const double from_m = upright.top_m + 2 * taken_m, to_m = upright.bottom_m;
    const auto bar = [&](const Triple<double>& begin_m, const Triple<double>& end_m, double r_m) {
      const double long_m = length_of(end_m - begin_m);
      const FaceSheet at = shelf.put(long_m, 2 * constants::pi * r_m);
      add_tube(builder, {begin_m, end_m, r_m}, patch_m, TubeSheet{at.left_m, at.top_m, true});
    };
    const double fender_m = radius_m + usual::fender_off_m;
    const double fender_r_m = sizes.fender_radius_m.value_or(usual::fender_radius_m);
    const double ladder_m = radius_m + usual::ladder_off_m;
    for (const double side : {-0.5, 0.5}) {
      bar(landing.at(fender_m, side * usual::fender_spacing_m, from_m),
          landing.at(fender_m, side * usual::fender_spacing_m, to_m), fender_r_m);
      shelf.next_row();
    }
    for (const double side : {-0.5, 0.5}) {
      bar(landing.at(ladder_m, side * usual::ladder_width_m, from_m),
          landing.at(ladder_m, side * usual::ladder_width_m, to_m), 2 * usual::rung_radius_m);
      shelf.next_row();
    }
    const std::size_t rungs = pieces_in(to_m - from_m, usual::rung_spacing_m);
    for (std::size_t i = 0; i < rungs; ++i) {
      const double z_m =
          from_m + (to_m - from_m) * (static_cast<double>(i) + 0.5) / static_cast<double>(rungs);
      bar(landing.at(ladder_m, -0.5 * usual::ladder_width_m, z_m),
          landing.at(ladder_m, 0.5 * usual::ladder_width_m, z_m), usual::rung_radius_m);
      if (shelf.left_m + usual::ladder_width_m > sheet.width_m) shelf.next_row();
    }
    shelf.next_row();
  }
  sheet.width_m = std::max(sheet.width_m, shelf.widest_m);
  sheet.height_m = shelf.top_m;
  sheet.down = "downwards; below: flange, bolts, fenders, ladder";
  return builder.finish(SurfaceKind::transition_piece, sheet);
}

}  // namespace slackwater::twin
