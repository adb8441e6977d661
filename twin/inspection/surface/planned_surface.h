#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fields/base/config.h"
#include "fields/base/constants.h"
#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

// What a surface is made from: its place and its sizes, NED of the run. What is nothing is left
// out: of usual_sizes.h.

/// An axis, and from where to where along it.
struct Upright {
  double north_m = 0;
  double east_m = 0;
  double top_m = 0;  ///< z
  double bottom_m = 0;
  bool operator==(const Upright&) const = default;
};

/// From where to where round an upright axis, clockwise.
struct Arc {
  double from_rad = 0;
  double arc_rad = 2 * constants::pi;  ///< all round

  [[nodiscard]] bool is_all_round() const noexcept { return arc_rad > 2 * constants::pi - 1e-9; }
  bool operator==(const Arc&) const = default;
};

struct MonopileSizes {
  Upright upright;
  double radius_m = 0;
  Arc arc;
  bool operator==(const MonopileSizes&) const = default;
};

struct TransitionPieceSizes {
  Upright upright;
  double radius_m = 0;
  std::optional<double> landing_rad;  ///< bearing; nothing: there is no boat landing
  std::optional<int> bolts;
  std::optional<double> flange_width_m;
  std::optional<double> flange_thickness_m;
  std::optional<double> fender_radius_m;
  bool operator==(const TransitionPieceSizes&) const = default;
};

struct TowerSizes {
  Upright upright;
  double radius_m = 0;  ///< of its foot
  std::optional<double> top_radius_m;
  Arc arc;
  bool operator==(const TowerSizes&) const = default;
};

struct NacelleSizes {
  Triple<double> hub_m;
  double rotor_faces_rad = 0;
  std::optional<double> length_m;
  std::optional<double> width_m;
  std::optional<double> tall_m;
  std::optional<double> ahead_m;
  std::optional<double> roof_rise_m;
  bool operator==(const NacelleSizes&) const = default;
};

struct BladeSizes {
  Triple<double> hub_m;
  int blade = 1;     ///< to 3
  double tip_m = 0;  ///< from the hub
  double rotor_faces_rad = 0;
  std::optional<double> rotor_azimuth_rad;
  std::optional<double> overhang_m;
  std::optional<double> root_m;
  std::optional<double> chord_m;
  std::optional<double> tip_chord_m;
  std::optional<double> root_thickness;  ///< of the chord
  std::optional<double> tip_thickness;
  std::optional<double> twist_rad;
  std::optional<double> pitch_rad;
  std::optional<double> camber;  ///< of the chord
  bool operator==(const BladeSizes&) const = default;
};

struct AnodesSizes {
  Upright upright;
  double radius_m = 0;  ///< of the pile
  std::optional<double> first_bearing_rad;
  std::optional<int> bars;
  std::optional<int> rows;
  std::optional<double> length_m;
  std::optional<double> width_m;
  std::optional<double> off_m;
  bool operator==(const AnodesSizes&) const = default;
};

struct MooringLineSizes {
  Triple<double> fairlead_m;
  Triple<double> anchor_m;
  std::optional<double> radius_m;
  std::optional<double> share;  ///< of the line, from its fairlead on
  bool operator==(const MooringLineSizes&) const = default;
};

struct CableSizes {
  /// On the bed above the cable.
  struct Point {
    Triple<double> bed_m;
    std::optional<double> burial_m;  ///< nothing: as everywhere
    bool operator==(const Point&) const = default;
  };
  std::vector<Point> route;
  std::optional<double> burial_m;  ///< of the cable's top
  std::optional<double> corridor_m;
  std::optional<double> radius_m;
  std::optional<double> off_ends_m;
  bool operator==(const CableSizes&) const = default;
};

struct BedSizes {
  struct Scour {
    double depth_m = 0;
    std::optional<double> width_m;
    std::optional<double> slope_rad;  ///< instead
    std::optional<double> skew;
    std::optional<double> deepest_rad;
    bool operator==(const Scour&) const = default;
  };
  Triple<double> foot_m;
  double radius_m = 0;  ///< of the foundation
  std::optional<double> outer_m;
  std::optional<Scour> scour;
  bool operator==(const BedSizes&) const = default;
};

struct WaterSizes {
  struct Disc {
    double north_m = 0;
    double east_m = 0;
    double radius_m = 0;
    std::optional<double> inner_m;
    bool operator==(const Disc&) const = default;
  };
  std::optional<Disc> disc;
  std::vector<Triple<double>> corners;  ///< of a convex piece; instead
  bool operator==(const WaterSizes&) const = default;
};

/// A surface that is to be inspected, as an entry of a scenario's `surfaces` says.
struct PlannedSurface {
  std::string name;               ///< "A01/monopile"
  std::optional<double> patch_m;  ///< goes before that of whoever makes it
  /// In the order of SurfaceKind.
  std::variant<MonopileSizes, TransitionPieceSizes, TowerSizes, NacelleSizes, BladeSizes,
               AnodesSizes, MooringLineSizes, CableSizes, BedSizes, WaterSizes>
      sizes;

  [[nodiscard]] SurfaceKind kind() const noexcept {
    return static_cast<SurfaceKind>(sizes.index());
  }
  bool operator==(const PlannedSurface&) const = default;
};

/// One entry of a scenario's `surfaces`. Numbers are absolute, NED of the run; a LEVEL is
/// {depth_m: 5} or {height_m: 12}. [in brackets]: what may be left out.
///
///     kind: monopile          north_m, east_m, radius_m, from: LEVEL, to: LEVEL,
///                             [bearings_deg: [FROM, TO]]
///     kind: transition_piece  north_m, east_m, radius_m, from, to, [landing_deg], [bolts],
///                             [flange_width_m], [flange_thickness_m], [fender_radius_m]
///         without landing_deg there is no boat landing
///     kind: tower             north_m, east_m, radius_m, from, to, [top_radius_m],
///                             [bearings_deg]
///     kind: nacelle           north_m, east_m, height_m (of the hub), rotor_faces_deg, [length_m],
///                             [width_m], [tall_m], [ahead_m], [roof_rise_m]
///     kind: blade             north_m, east_m, height_m (of the hub), blade: 1, tip_m,
///                             rotor_faces_deg, [rotor_azimuth_deg], [overhang_m], [root_m],
///                             [chord_m], [tip_chord_m], [root_thickness], [tip_thickness],
///                             [twist_deg], [pitch_deg], [camber]
///     kind: anodes            north_m, east_m, radius_m, from, to, [bars], [rows],
///                             [first_bearing_deg], [length_m], [width_m], [off_m]
///         rows are spread between from and to, as the stops of `pattern: verticals` are
///     kind: mooring_line      fairlead: {north_m, east_m, depth_m}, anchor: {...}, [radius_m],
///                             [share]
///     kind: cable             route: [{north_m, east_m, depth_m, [burial_m]}, ...], [burial_m],
///                             [corridor_m], [radius_m], [off_ends_m]
///         depth_m is the bed's; the corridor of bed above the cable is patched
///     kind: bed               north_m, east_m, depth_m, radius_m (of the foundation), [outer_m],
///                             [scour: {depth_m: 2, slope_deg: 32 or width_m: 4, skew: 0.3,
///                             deepest_deg: 80}]
///     kind: water             north_m, east_m, radius_m, [inner_m]; or corners: [{north_m,
///                             east_m}, ...] of a convex piece
///
/// All take [name] and [patch_m].
/// @throws Error(invalid_input) also for one that cannot be made (make_surface.h)
[[nodiscard]] PlannedSurface read_surface(const Config& entry);
/// The same where a site states what the entry does not. Levels are the site's.
/// @param stated  of the entry's kind
[[nodiscard]] PlannedSurface read_surface(const Config& entry, const PlannedSurface& stated);

/// monopile, ... @throws Error(invalid_input) about the key, with the nearest word
[[nodiscard]] SurfaceKind surface_kind_of(std::string_view word, const Config& config,
                                          std::string_view key);

}  // namespace slackwater::twin
