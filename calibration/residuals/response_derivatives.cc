#include "calibration/residuals/response_derivatives.h"

#include <ceres/jet.h>

#include <vector>

namespace slackwater::calibration {
namespace {

using Dual = ceres::Jet<double, 2>;

Complex<double> value(const Complex<Dual>& x) { return {x.re.a, x.im.a}; }
Complex<double> derivative(const Complex<Dual>& x, int i) { return {x.re.v[i], x.im.v[i]}; }

}  // namespace

void response_derivatives(SteadyForm form, double log_viscosity, double log_bottom, Angle latitude,
                          double water_depth_m, std::span<const double> depths_m,
                          std::span<ResponseDerivatives> out) {
  expects(out.size() == depths_m.size(), "one result per depth");
  std::vector<LevelResponse<Dual>> response(depths_m.size());
  steady_responses<Dual>(form, exp(Dual(log_viscosity, 0)), exp(Dual(log_bottom, 1)), latitude,
                         water_depth_m, depths_m, response);
  for (std::size_t k = 0; k < response.size(); ++k) {
    const LevelResponse<Dual>& r = response[k];
    out[k] = {value(r.interior), derivative(r.interior, 0), derivative(r.interior, 1),
              value(r.stress),   derivative(r.stress, 0),   derivative(r.stress, 1)};
  }
}

}  // namespace slackwater::calibration
