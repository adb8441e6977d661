#pragma once
#include "fields/site/site.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// The turbines of a site on the plane about its point, with what the site says of them.
/// @throws Error(invalid_input) for a site without turbines or without a depth of water
[[nodiscard]] WorkSite work_site_of(const Site& site);

}  // namespace slackwater::twin
