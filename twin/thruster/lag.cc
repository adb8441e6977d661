#include "twin/thruster/lag.h"

#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

double left_after(double time_constant_s, double dt_s) {
  return time_constant_s > 0 ? std::exp(-dt_s / time_constant_s) : 0;
}
double mean_left(double time_constant_s, double dt_s) {
  return time_constant_s > 0 ? -std::expm1(-dt_s / time_constant_s) * (time_constant_s / dt_s) : 0;
}

}  // namespace

LagStep lag_step(double rise_s, double fall_s, double dt_s) {
  expects(dt_s > 0 && rise_s >= 0 && fall_s >= 0, "a lag has a step and no negative time constant");
  return {left_after(rise_s, dt_s), left_after(fall_s, dt_s), mean_left(rise_s, dt_s),
          mean_left(fall_s, dt_s)};
}

}  // namespace slackwater::twin
