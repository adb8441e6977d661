#pragma once
#include "tests/twin/scenario/random_values.h"
#include "twin/inspection/surface/planned_surface.h"

namespace slackwater::tests {

/// Surfaces of every kind that can be made.
class RandomSurface : protected RandomValues {
 public:
  explicit RandomSurface(std::uint64_t seed) : RandomValues(seed) {}

  twin::PlannedSurface surface() {
    twin::PlannedSurface surface;
    surface.name = name();
    if (chance(0.3)) surface.patch_m = number(1, 3);
    switch (count(0, 9)) {
      case 0:
        surface.sizes = twin::MonopileSizes{upright(number(-5, 5)), number(1, 5), arc()};
        break;
      case 1:
        surface.sizes = transition_piece();
        break;
      case 2:
        surface.sizes = twin::TowerSizes{upright(-number(60, 90)), number(2, 5),
                                         maybe(chance(0.5), number(0.5, 4)), arc()};
        break;
      case 3:
        surface.sizes = nacelle();
        break;
      case 4:
        surface.sizes = blade();
        break;
      case 5:
        surface.sizes = anodes();
        break;
      case 6:
        surface.sizes = twin::MooringLineSizes{{number(-99, 99), number(-99, 99), number(1, 20)},
                                               {number(-99, 99), number(-99, 99), number(40, 90)},
                                               maybe(chance(0.5), number(0.1, 2)),
                                               maybe(chance(0.5), number(0.5, 1))};
        break;
      case 7:
        surface.sizes = cable();
        break;
      case 8:
        surface.sizes = bed();
        break;
      default:
        surface.sizes = water();
    }
    return surface;
  }

 private:
  static std::optional<double> maybe(bool is_said, double value) {
    return is_said ? std::optional(value) : std::nullopt;
  }
  twin::Upright upright(double top_m) {
    return {number(-50e3, 50e3), number(-50e3, 50e3), top_m, top_m + number(20, 40)};
  }
  twin::Arc arc() {
    if (chance(0.5)) return {};
    const double from_deg = number(-360, 360), to_deg = from_deg + number(1, 359);
    return {from_deg * degree, (to_deg - from_deg) * degree};
  }
  twin::Triple<double> hub() {
    return {number(-50e3, 50e3), number(-50e3, 50e3), -number(90, 150)};
  }
  twin::TransitionPieceSizes transition_piece() {
    twin::TransitionPieceSizes piece;
    piece.upright = upright(-number(10, 20));
    piece.radius_m = number(2, 5);
    if (chance(0.5)) {
      piece.landing_rad = angle();
      piece.fender_radius_m = maybe(chance(0.5), number(0.1, 1));
    }
    if (chance(0.5)) piece.bolts = static_cast<int>(count(0, 100));
    piece.flange_width_m = maybe(chance(0.5), number(0.1, 1));
    piece.flange_thickness_m = maybe(chance(0.5), number(0.05, 0.5));
    return piece;
  }
  twin::NacelleSizes nacelle() {
    return {hub(),
            angle(),
            maybe(chance(0.5), number(5, 20)),
            maybe(chance(0.5), number(3, 6)),
            maybe(chance(0.5), number(3, 6)),
            maybe(chance(0.5), number(-9, 9)),
            maybe(chance(0.5), number(0, 1))};
  }
  twin::BladeSizes blade() {
    twin::BladeSizes blade;
    blade.hub_m = hub();
    blade.blade = static_cast<int>(count(1, 3));
    blade.tip_m = number(30, 80);
    blade.rotor_faces_rad = angle();
    blade.rotor_azimuth_rad = maybe(chance(0.5), angle());
    blade.overhang_m = maybe(chance(0.5), number(0, 10));
    blade.root_m = maybe(chance(0.5), number(1, 5));
    blade.chord_m = maybe(chance(0.5), number(2, 5));
    blade.tip_chord_m = maybe(chance(0.5), number(0.5, 2));
    blade.root_thickness = maybe(chance(0.5), number(0.3, 0.6));
    blade.tip_thickness = maybe(chance(0.5), number(0.1, 0.3));
    blade.twist_rad = maybe(chance(0.5), angle(-20, 20));
    blade.pitch_rad = maybe(chance(0.5), angle(-90, 90));
    blade.camber = maybe(chance(0.5), number(0, 0.1));
    return blade;
  }
  twin::AnodesSizes anodes() {
    twin::AnodesSizes anodes;
    anodes.upright = upright(number(0, 5));
    anodes.radius_m = number(2, 5);
    anodes.first_bearing_rad = maybe(chance(0.5), angle());
    if (chance(0.5)) anodes.bars = static_cast<int>(count(1, 6));
    if (chance(0.5)) anodes.rows = static_cast<int>(count(1, 3));
    anodes.length_m = maybe(chance(0.5), number(0.5, 2));
    anodes.width_m = maybe(chance(0.5), number(0.1, 0.4));
    anodes.off_m = maybe(chance(0.5), number(0.25, 1));
    return anodes;
  }
  twin::CableSizes cable() {
    twin::CableSizes cable;
    const std::size_t points = count(2, 4);
    for (std::size_t i = 0; i < points; ++i)
      cable.route.push_back({{100.0 * static_cast<double>(i), number(-20, 20), number(30, 35)},
                             maybe(chance(0.3), number(0, 3))});
    cable.burial_m = maybe(chance(0.5), number(0, 3));
    cable.corridor_m = maybe(chance(0.5), number(1, 20));
    cable.radius_m = maybe(chance(0.5), number(0.05, 1));
    cable.off_ends_m = maybe(chance(0.5), number(0, 30));
    return cable;
  }
  twin::BedSizes bed() {
    twin::BedSizes bed;
    bed.foot_m = {number(-50e3, 50e3), number(-50e3, 50e3), number(20, 90)};
    bed.radius_m = number(2, 4);
    bed.outer_m = maybe(chance(0.5), number(15, 30));
    if (chance(0.5)) return bed;
    twin::BedSizes::Scour& scour = *(bed.scour = twin::BedSizes::Scour{});
    scour.depth_m = number(0, 2);
    if (chance(0.5))
      scour.width_m = number(1, 5);
    else
      scour.slope_rad = maybe(chance(0.5), angle(25, 45));
    scour.skew = maybe(chance(0.5), number(0, 0.9));
    scour.deepest_rad = maybe(chance(0.5), angle());
    return bed;
  }
  twin::WaterSizes water() {
    twin::WaterSizes water;
    if (chance(0.5))
      water.disc = {number(-50e3, 50e3), number(-50e3, 50e3), number(10, 30),
                    maybe(chance(0.5), number(0, 5))};
    else
      water.corners = {{0, 0, 0}, {number(10, 20), 0, 0}, {0, 20.5, 0}};
    return water;
  }
};

}  // namespace slackwater::tests
