#include "fields/current/steady_column.h"

namespace slackwater {

std::string_view name_of(SteadyForm form) noexcept {
  switch (form) {
    case SteadyForm::three_layer:
      return "three_layer";
    case SteadyForm::finite_depth:
      return "finite_depth";
    case SteadyForm::mixed_layer:
      return "mixed_layer";
  }
  return "unknown";
}

ColumnShape<double> shape_of(SteadyForm form, const SteadyParameters& parameters) noexcept {
  const double bottom = form == SteadyForm::finite_depth  ? parameters.bottom_friction_m_s
                        : form == SteadyForm::mixed_layer ? parameters.base_friction_m_s
                                                          : parameters.bottom_eddy_viscosity_m2_s;
  return {parameters.eddy_viscosity_m2_s, bottom, parameters.mixed_layer_depth_m};
}

SteadyForm default_form(double water_depth_m, Angle latitude, double eddy_viscosity_m2_s) {
  expects(water_depth_m > 0, "water depth must be positive");
  if (is_equatorial(latitude)) return SteadyForm::finite_depth;
  const double depth_m = ekman_depth_m(eddy_viscosity_m2_s, coriolis_parameter_rad_s(latitude));
  return water_depth_m < 2.0 * (depth_m + depth_m) ? SteadyForm::finite_depth
                                                   : SteadyForm::three_layer;
}

LevelResponses level_responses(SteadyForm form, const SteadyParameters& parameters, Angle latitude,
                               double water_depth_m, std::span<const double> depths_m) {
  const ColumnShape<double> shape = shape_of(form, parameters);
  expects(shape.eddy_viscosity_m2_s > 0 && shape.bottom > 0 && shape.mixed_layer_depth_m > 0 &&
              parameters.stress_factor > 0,
          "eddy viscosity, bottom parameter, layer depth and stress factor must be positive");
  expects(water_depth_m > 0, "water depth must be positive");

  const std::size_t levels = depths_m.size();
  std::vector<LevelResponse<double>> response(levels);
  steady_responses<double>(form, shape, latitude, water_depth_m, depths_m, response);

  LevelResponses result;
  result.depth_m.assign(depths_m.begin(), depths_m.end());
  result.interior_re.resize(levels);
  result.interior_im.resize(levels);
  result.stress_re.resize(levels);
  result.stress_im.resize(levels);
  for (std::size_t k = 0; k < levels; ++k) {
    result.interior_re[k] = response[k].interior.re;
    result.interior_im[k] = response[k].interior.im;
    result.stress_re[k] = parameters.stress_factor * response[k].stress.re;
    result.stress_im[k] = parameters.stress_factor * response[k].stress.im;
  }
  return result;
}

}  // namespace slackwater
