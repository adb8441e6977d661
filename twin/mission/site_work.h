#pragma once
#include "fields/geo/local_frame.h"
#include "fields/site/site.h"
#include "twin/mission/work_site.h"

namespace slackwater::twin {

/// The turbines of a site on the plane about its point, with what the site says of them.
/// @throws Error(invalid_input) for a site without turbines or without a depth of water
[[nodiscard]] WorkSite work_site_of(const Site& site);

/// What lies at a site beside its turbines.
struct SiteLines {
  std::vector<WorkCable> cables;
  std::vector<MooringLine> moorings;  ///< "TURBINE LINE" by name
};
/// As far as the site says enough of them, which a look at it needs not: cables lie at its depth of
/// water (nan where it has none), lines of turbines without a depth or a foundation are left out.
/// @param frame  whose plane they are laid on
[[nodiscard]] SiteLines site_lines_of(const Site& site, const LocalFrame& frame);

}  // namespace slackwater::twin
