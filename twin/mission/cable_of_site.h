#pragma once
#include <string>

#include "fields/base/config.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// The cable that an entry of a task is about, of the site at whose turbine the work is:
///
///     cable: A01-A02           by its id
///     cable_role: array        the nearest that joins turbines
///     cable_role: export       the nearest that leads off
///
/// The nearest comes nearest to the turbine's axis anywhere along its route; of those as near, the
/// first in the site's file. A task with a role is of any site that has such a cable.
/// @throws Error(invalid_input) for none or both of them, and for what the site does not have, with
/// what it has
[[nodiscard]] const WorkCable& cable_of_site(const Config& entry, const WorkSite& site,
                                             const WorkTurbine& turbine);

/// Whether an entry names a cable, by its id or its role.
[[nodiscard]] bool names_cable(const Config& entry);

/// array, export.
[[nodiscard]] const char* name_of(CableRole role) noexcept;

}  // namespace slackwater::twin
