#include "calibration/solve/parameter_set.h"

#include <algorithm>
#include <cmath>

namespace slackwater::calibration {
namespace {

/// One component of a vector, in its own unit.
Parameter component(std::string name, const char* unit, double sigma, double bound,
                    const char* source) {
  Parameter p;
  p.name = std::move(name);
  p.unit = unit;
  p.prior = 0.0;
  p.prior_sigma = sigma;
  p.lower = -bound;
  p.upper = bound;
  p.source = source;
  return p;
}

void add_vector(std::vector<Parameter>& set, const std::string& name, const char* unit,
                double sigma, double bound, const char* source) {
  for (const char* part : {"_east", "_north"})
    set.push_back(component(name + part, unit, sigma, bound, source));
}

Parameter positive(const char* name, const char* unit, double prior, double log_sigma, double lower,
                   double upper, const char* source) {
  Parameter p;
  p.name = name;
  p.unit = unit;
  p.prior = prior;
  p.prior_sigma = log_sigma;
  p.lower = lower;
  p.upper = upper;
  p.is_logarithmic = true;
  p.source = source;
  return p;
}

Parameter bottom_parameter(SteadyForm form) {
  const SteadyParameters typical;
  switch (form) {
    case SteadyForm::finite_depth:
      return positive(
          "bottom_friction", "m s-1", typical.bottom_friction_m_s, 1.0, 1e-5, 2e-2,
          "Cd 2.5e-3 (Soulsby 1997) times 0.2 m/s at the bed; linear coefficients near 2e-4 "
          "(Haidvogel and Beckmann 1999, section 5.6.6) lie within one sigma");
    case SteadyForm::mixed_layer:
      return positive(
          "base_friction", "m s-1", typical.base_friction_m_s, 1.0, 1e-6, 2e-2,
          "inertial motion of a 25 m layer decays in 1 to 4 days (D'Asaro 1985, J. Phys. "
          "Oceanogr. 15, 1043): r h = 7e-5 to 3e-4 m/s; a factor e either way");
    case SteadyForm::three_layer:
      break;
  }
  return positive("bottom_eddy_viscosity", "m2 s-1", typical.bottom_eddy_viscosity_m2_s, 1.5, 1e-5,
                  1.0,
                  "u*^2/(200 |f|) (Csanady 1982, Circulation in the Coastal Ocean) for a friction "
                  "velocity u* of 1 cm/s at mid-latitude; half a decade either way");
}

Parameter layer_parameter(double water_depth_m) {
  const SteadyParameters typical;
  Parameter p = positive("mixed_layer_depth", "m", typical.mixed_layer_depth_m, 0.6, 3.0, 300.0,
                         "10 to 20 m in summer and 50 to 100 m in winter at mid-latitude (de Boyer "
                         "Montegut et al. 2004, J. Geophys. Res. 109, C12003): geometric middle");
  p.upper = std::clamp(water_depth_m, 2.0 * p.lower, p.upper);
  p.prior = std::min(p.prior, 0.7 * p.upper);
  return p;
}

void add_known(std::vector<Parameter>& set, const std::vector<KnownParameter>& known) {
  for (const KnownParameter& k : known) {
    for (Parameter& p : set) {
      if (p.name != k.name || !(k.sigma > 0) || !std::isfinite(k.value)) continue;
      p.prior = std::clamp(k.value, p.lower, p.upper);
      p.prior_sigma = k.sigma;
      p.source = k.source;
    }
  }
}

}  // namespace

std::vector<Parameter> prior_parameters(const ParameterLayout& layout, double water_depth_m,
                                        const std::vector<KnownParameter>& known) {
  const SteadyParameters typical;
  std::vector<Parameter> set;
  add_vector(set, "interior", "m s-1", 1.0, 5.0, "weak: sub-daily mean currents rarely pass 1 m/s");
  if (layout.has_shape) {
    set.push_back(
        positive("eddy_viscosity", "m2 s-1", typical.eddy_viscosity_m2_s, 1.2, 1e-4, 1.0,
                 "geometric middle of O(0.01) m2/s (Chereskin 1995, doi 10.1029/95JC02182) and "
                 "0.08 to 0.12 m2/s (Polton et al. 2013, doi 10.1175/JPO-D-13-034.1); a factor 3 "
                 "either way"));
    set.push_back(bottom_parameter(layout.form));
  }
  if (layout.has_wind) {
    set.push_back(positive(
        "stress_factor", "1", typical.stress_factor, 0.3, 0.1, 10.0,
        "spread of published drag laws (7 to 14 % between Charnock and the linear law) and "
        "a 10 % error of the wind speed, in quadrature and rounded up"));
  }
  if (layout.has_layer()) set.push_back(layer_parameter(water_depth_m));
  if (layout.is_unsteady) {
    add_vector(set, "interior_trend", "m s-1 d-1", 0.05, 2.0,
               "the error of one day's mean as a forecast of the next is 0.04 to 0.06 m/s a "
               "component on regional products");
  }
  if (layout.has_modes()) {
    add_vector(
        set, "inertial", "m s-1", 0.15, 3.0,
        "usual after a storm (D'Asaro 1985; Pollard and Millard 1970, Deep-Sea Res. 17, 813)");
  }
  add_known(set, known);
  return set;
}

double estimated(const Parameter& parameter, double value) {
  return parameter.is_logarithmic ? std::log(value) : value;
}

std::vector<double> estimates_of(const std::vector<Parameter>& parameters) {
  std::vector<double> estimate;
  estimate.reserve(parameters.size());
  for (const Parameter& p : parameters) estimate.push_back(estimated(p, p.value));
  return estimate;
}

std::vector<double> without_flow(std::vector<double> estimate, const ParameterLayout& layout) {
  const auto clear = [&](std::size_t from) { estimate[from] = estimate[from + 1] = 0; };
  clear(ParameterLayout::interior);
  if (layout.is_unsteady) clear(layout.trend());
  if (layout.has_modes()) clear(layout.inertial());
  return estimate;
}

double physical(const Parameter& parameter, double estimate) {
  return parameter.is_logarithmic ? std::exp(estimate) : estimate;
}

Prior prior_of(const Parameter& parameter) {
  return {estimated(parameter, parameter.prior), parameter.prior_sigma};
}

}  // namespace slackwater::calibration
