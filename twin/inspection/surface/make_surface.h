#pragma once
#include <string_view>

#include "fields/base/config.h"
#include "twin/inspection/surface/surface.h"

namespace slackwater::twin {

/// One entry of a scenario's `surfaces`, cut into patches about `patch_m` on a side: as few as are
/// no longer. Numbers are absolute, NED of the run; a LEVEL is {depth_m: 5} or {height_m: 12}.
/// [in brackets]: what may be left out; sizes that are left out are those of usual_sizes.h.
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
///                             [scour: see scour_pit.h]
///     kind: water             north_m, east_m, radius_m, [inner_m]; or corners: [{north_m,
///                             east_m}, ...] of a convex piece
///
/// All take [name] and [patch_m], which goes before the argument. Solids are closed. At most
/// 400 000 patches and 2 000 000 triangles: an entry's own patch_m that would make more is refused,
/// the argument is taken as a wish and made longer.
///
/// @throws Error(invalid_input)
[[nodiscard]] Surface make_surface(const Config& config, double patch_m);

/// monopile, ... @throws Error(invalid_input) about the key, with the nearest word
[[nodiscard]] SurfaceKind surface_kind_of(std::string_view word, const Config& config,
                                          std::string_view key);

}  // namespace slackwater::twin
