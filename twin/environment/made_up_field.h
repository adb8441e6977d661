#pragma once
#include <memory>

#include "fields/service/field.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// Made-up water as a forecast that says the same at every place within half a degree of the origin
/// and at all times from `from` to `to`. The current is linear between its levels, and that of the
/// first and last holds above and below.
[[nodiscard]] std::shared_ptr<const Field> made_up_field(const MadeUpWater& water,
                                                         const GeoPoint& origin, UtcTime from,
                                                         UtcTime to);

/// The same with a current that changes: `current` is times x depths.
[[nodiscard]] std::shared_ptr<const Field> made_up_field(std::vector<UtcTime> times,
                                                         std::vector<double> depths_m,
                                                         const std::vector<Horizontal>& current,
                                                         Horizontal wind_m_s,
                                                         const GeoPoint& origin,
                                                         double water_depth_m);

}  // namespace slackwater::twin
