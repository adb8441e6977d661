#pragma once
#include "fields/wave/sea_realisation.h"
#include "twin/body/body.h"

namespace slackwater::twin {

/// The sea at the strips of one craft, `t_s` seconds after the sea's epoch; both have their origin
/// at the same place.
///
/// A strip whose place is above the surface is all but dry: it has the elevation as its head and no
/// motion. Outside the sea's reach all is NaN. No allocation. Cost: `sample_waves` at each strip.
[[nodiscard]] WaterAtStrips<double> waves_at_strips(const SeaRealisation& sea, double t_s,
                                                    const FloatingHull& hull,
                                                    const BodyState<double>& state);

}  // namespace slackwater::twin
