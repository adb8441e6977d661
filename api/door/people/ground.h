#pragma once
#include <nlohmann/json.hpp>

#include "api/door/people/run_place.h"

namespace slackwater::people {

// What lies in the water of a run and does not change while it goes on; api/docs/session_wire.md.

/// The bed about the origin as the vehicles have it, on a square grid as wide as what stands and
/// goes there: {east_m, north_m, step_m, across, up_m}, rows from the south, each from the west;
/// null where nobody knows the bed. Null: nobody knows it anywhere.
/// @param vehicles_m  where they begin: east, north
[[nodiscard]] nlohmann::json bed_json(const RunPlace& place,
                                      std::span<const Horizontal> vehicles_m);

/// [{id, route, burial_m}], on the bed where it is known.
[[nodiscard]] nlohmann::json cables_json(const RunPlace& place);

/// [{id, fairlead, anchor}]: the straight way between the ends of each line.
[[nodiscard]] nlohmann::json moorings_json(const twin::SiteLines& lines);

}  // namespace slackwater::people
