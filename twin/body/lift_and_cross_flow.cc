#include "twin/body/lift_and_cross_flow.h"

#include <cmath>

namespace slackwater::twin {

Spatial<double> resistance_along_axes(const Body& body) {
  Spatial<double> sum = body.quadratic_damping;
  const CrossFlow& flow = body.cross_flow;
  for (std::size_t i = 0; i < flow.strips; ++i) {
    const double arm3_m3 = std::pow(std::abs(flow.x_m[i]), 3);
    sum.linear.y += flow.sway_n_s2_m2[i];
    sum.linear.z += flow.heave_n_s2_m2[i];
    sum.angular.y += arm3_m3 * flow.heave_n_s2_m2[i];
    sum.angular.z += arm3_m3 * flow.sway_n_s2_m2[i];
  }
  return sum;
}

}  // namespace slackwater::twin
