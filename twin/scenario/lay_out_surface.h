#pragma once
#include "fields/base/config.h"
#include "twin/inspection/surface/planned_surface.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// One entry of a task's `surfaces`, laid out at a turbine: the entry of a scenario
/// (twin/inspection/surface/planned_surface.h), with the place and the sizes that the site
/// states. What the entry says itself is handed on. A LEVEL is that of work_pattern.h, and
/// [in brackets] stands what may be left out:
///
///     kind: monopile           [from: the sea's surface], [to: its foot]
///     kind: transition_piece   [from: its top], [to: 3 m deep]
///     kind: tower              [from: 2.4 m below the hub], [to: the transition piece's top]
///     kind: nacelle            rotor_faces_deg
///     kind: blade              blade: 1, rotor_faces_deg, [rotor_azimuth_deg], as `pattern: blade`
///     kind: anodes             [from: 5 m deep], [to: 3 m above its foot]
///         the first bar is where the boat landing is
///     kind: mooring_line       mooring: ID
///     kind: cable              cable: ID or cable_role: array, [burial_m], [off_ends_m: 40]
///         the same entry for whatever turbine has that cable (cable_of_site.h)
///     kind: bed                as it is there
///     kind: water              [radius_m: 500], or corners
///
/// @throws Error(invalid_input) for what the site does not have (a hub, a rotor, a cable, a line)
[[nodiscard]] PlannedSurface lay_out_surface(const Config& entry, const WorkSite& site,
                                             const WorkTurbine& turbine);

}  // namespace slackwater::twin
