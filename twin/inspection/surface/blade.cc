#include <algorithm>
#include <cmath>
#include <optional>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/inspection/surface/patched_grid.h"
#include "twin/inspection/surface/rotor_axes.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/usual_sizes.h"
#include "twin/inspection/surface/wing_section.h"

namespace slackwater::twin {
namespace {

constexpr double axis_at = 0.3;  // of the chord: where the blade's axis goes through its sections

/// A blade from its root to its tip: chord, thickness and twist change evenly.
struct BladeShape {
  Triple<double> hub_m;
  BladeAxes axes;
  double root_m = 0;  ///< from the hub
  double tip_m = 0;
  double root_chord_m = 0;
  double tip_chord_m = 0;
  double root_thickness = 0;
  double tip_thickness = 0;
  double root_twist_rad = 0;
  double pitch_rad = 0;
  double camber = 0;

  double chord_m(double share) const { return root_chord_m + (tip_chord_m - root_chord_m) * share; }
  double twist_rad(double share) const { return pitch_rad + root_twist_rad * (1 - share); }
  WingSection section(double share) const {
    return {root_thickness + (tip_thickness - root_thickness) * share, camber};
  }
  Triple<double> at(const SectionPoint& point, double share) const {
    const double c = std::cos(twist_rad(share)), s = std::sin(twist_rad(share));
    // Twist turns the leading edge upwind.
    const Triple<double> lead = c * axes.across + s * axes.upwind;
    const Triple<double> suction = s * axes.across - c * axes.upwind;
    return hub_m + (root_m + (tip_m - root_m) * share) * axes.along +
           chord_m(share) * ((axis_at - point.x) * lead + point.y * suction);
  }
};

BladeShape shape_of(const BladeSizes& sizes) {
  BladeShape blade;
  blade.axes = blade_axes(sizes.rotor_faces_rad,
                          blade_azimuth_rad(sizes.blade, sizes.rotor_azimuth_rad.value_or(0)));
  blade.hub_m = sizes.hub_m + sizes.overhang_m.value_or(usual::overhang_m) * blade.axes.upwind;
  blade.tip_m = sizes.tip_m;
  const double scale = blade.tip_m / usual::rotor_radius_m;
  blade.root_m = sizes.root_m.value_or(usual::blade_root_m);
  if (!(blade.root_m < blade.tip_m))
    throw Unmakeable{"root_m", formatted("at {:g} m is not before the tip, at {:g} m from the hub",
                                         blade.root_m, blade.tip_m)};
  blade.root_chord_m = sizes.chord_m.value_or(scale * usual::blade_chord_m);
  blade.tip_chord_m = sizes.tip_chord_m.value_or(scale * usual::blade_tip_chord_m);
  blade.root_thickness = sizes.root_thickness.value_or(usual::blade_root_thickness);
  blade.tip_thickness = sizes.tip_thickness.value_or(usual::blade_tip_thickness);
  blade.root_twist_rad = sizes.twist_rad.value_or(usual::blade_twist_deg * constants::degree);
  blade.pitch_rad = sizes.pitch_rad.value_or(0);
  blade.camber = sizes.camber.value_or(usual::blade_camber);
  return blade;
}

}  // namespace

Surface make(const BladeSizes& sizes, double patch_m) {
  constexpr double least_columns = 8, least_corners = 48;
  const BladeShape blade = shape_of(sizes);
  const double length_m = blade.tip_m - blade.root_m;
  double widest_m = 0;
  for (int i = 0; i <= 10; ++i)
    widest_m = std::max(widest_m, blade.chord_m(0.1 * i) * blade.section(0.1 * i).girth());
  PatchedGrid grid;
  grid.columns = std::max(pieces_in(widest_m, patch_m), pieces_in(least_columns, 1));
  grid.across = odd_from(least_corners / static_cast<double>(grid.columns));
  grid.rows = pieces_in(length_m, patch_m);
  grid.high = odd_from(std::min(length_m / static_cast<double>(grid.rows), 9.0));
  grid.wraps = true;
  const double columns = static_cast<double>(grid.columns), rows = static_cast<double>(grid.rows);
  // Rows come one after the other: each section is drawn once.
  std::optional<WingSection> section;
  double section_row = -1;
  const auto section_at = [&](double row) -> const WingSection& {
    if (section_row != row) section.emplace(blade.section(row / rows));
    section_row = row;
    return *section;
  };
  grid.at = [&](double column, double row) {
    return blade.at(section_at(row).at(column / columns), row / rows);
  };
  grid.sheet = [&](std::size_t column, std::size_t row) -> std::optional<SheetCell> {
    const double middle = static_cast<double>(row) + 0.5;
    const double girth_m = blade.chord_m(middle / rows) * section_at(middle).girth();
    const double round = (static_cast<double>(column) + 0.5) / columns;
    return SheetCell{0.5 * widest_m + (round - 0.5) * girth_m, middle * length_m / rows,
                     girth_m / columns, length_m / rows};
  };
  SurfaceBuilder builder(blade.hub_m);
  close_ends(builder, add_grid(builder, grid));
  Sheet sheet;
  sheet.width_m = widest_m;
  sheet.height_m = length_m;
  sheet.is_all_round = true;
  sheet.along = "round the section: trailing edge, pressure side, leading edge, suction side";
  sheet.down = "from the root to the tip";
  return builder.finish(SurfaceKind::blade, sheet);
}

}  // namespace slackwater::twin
