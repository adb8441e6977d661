#include "tests/support/unsteady_column.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"
#include "fields/current/column_modes.h"
#include "fields/current/coriolis.h"
#include "fields/current/mixed_layer.h"

namespace slackwater {

double moving_layer_m(SteadyForm form, const SteadyParameters& parameters,
                      double water_depth_m) noexcept {
  return form == SteadyForm::mixed_layer ? parameters.mixed_layer_depth_m : water_depth_m;
}

UnsteadyColumn::UnsteadyColumn(SteadyForm form, const SteadyParameters& parameters, Angle latitude,
                               double water_depth_m, std::span<const double> depths_m,
                               const HourlyStress& stress)
    : levels_(depths_m.size()) {
  if (form == SteadyForm::three_layer || is_equatorial(latitude)) return;
  const ColumnShape<double> shape = shape_of(form, parameters);
  const double layer_m = moving_layer_m(form, parameters, water_depth_m);
  const auto modes = column_modes(shape.eddy_viscosity_m2_s, shape.bottom, layer_m,
                                  coriolis_parameter_rad_s(latitude), [](double x) { return x; });
  for (const ColumnMode<double>& mode : modes) {
    memory_.emplace_back(stress, 3600.0 * to_horizontal(mode.decay_1_s));
    const Horizontal scale = parameters.stress_factor * to_horizontal(mode.per_pascal);
    for (const double d : depths_m) {
      const double taper =
          form == SteadyForm::mixed_layer ? MixedLayerColumn<double>::base_taper(layer_m, d) : 1.0;
      response_.push_back(taper * scale * std::cos(mode.wavenumber_1_m * std::min(d, layer_m)));
    }
  }
}

void UnsteadyColumn::transient(const TimeCell& cell, std::span<Horizontal> out) const {
  expects(out.size() == levels_, "one value per depth");
  std::fill(out.begin(), out.end(), Horizontal{});
  for (std::size_t n = 0; n < memory_.size(); ++n) {
    const Horizontal memory = memory_[n].over(cell).memory_pa;
    for (std::size_t k = 0; k < levels_; ++k) out[k] -= response_[n * levels_ + k] * memory;
  }
}

}  // namespace slackwater
