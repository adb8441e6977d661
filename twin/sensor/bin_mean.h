#pragma once
#include "twin/sensor/adcp.h"

namespace slackwater::twin {

/// The flow along a ray, averaged over the bin of an ADCP whose centre lies `centre_m` along the
/// instrument's axis, by the triangle that reaches over half of both neighbours: seven places a
/// quarter of a bin apart. Exact for a flow that is linear in range; of a curved one the mean is
/// that of the middle and 5/64 of the curvature times the square of a bin, where the whole triangle
/// would give 1/12.
/// @param along  cosine of the ray's angle off the axis
[[nodiscard]] Triple<double> bin_mean(const Adcp& adcp, const WaterAt& water, const Ray& ray,
                                      double centre_m, double along);

}  // namespace slackwater::twin
