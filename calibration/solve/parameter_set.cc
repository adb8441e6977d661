#include "calibration/solve/parameter_set.h"

#include <cmath>

namespace slackwater::calibration {
namespace {

Parameter interior(const char* name) {
  Parameter p;
  p.name = name;
  p.unit = "m s-1";
  p.prior = 0.0;
  p.prior_sigma = 1.0;
  p.lower = -5.0;
  p.upper = 5.0;
  p.source = "weak: sub-daily mean currents rarely pass 1 m/s";
  return p;
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

}  // namespace

std::vector<Parameter> prior_parameters(SteadyForm form, bool is_equatorial, bool wind_used) {
  const SteadyParameters typical;
  std::vector<Parameter> set{interior("interior_east"), interior("interior_north")};
  if (is_equatorial) return set;
  set.push_back(
      positive("eddy_viscosity", "m2 s-1", typical.eddy_viscosity_m2_s, 1.2, 1e-4, 1.0,
               "geometric middle of O(0.01) m2/s (Chereskin 1995, doi 10.1029/95JC02182) and "
               "0.08 to 0.12 m2/s (Polton et al. 2013, doi 10.1175/JPO-D-13-034.1); a factor 3 "
               "either way"));
  if (form == SteadyForm::finite_depth) {
    set.push_back(
        positive("bottom_friction", "m s-1", typical.bottom_friction_m_s, 1.0, 1e-5, 2e-2,
                 "Cd 2.5e-3 (Soulsby 1997) times 0.2 m/s at the bed; linear coefficients near 2e-4 "
                 "(Haidvogel and Beckmann 1999, section 5.6.6) lie within one sigma"));
  } else {
    set.push_back(positive("bottom_eddy_viscosity", "m2 s-1", typical.bottom_eddy_viscosity_m2_s,
                           1.5, 1e-5, 1.0,
                           "u*^2/(200 |f|) (Csanady 1982, Circulation in the Coastal Ocean) for a "
                           "friction velocity u* of "
                           "1 cm/s at mid-latitude; half a decade either way"));
  }
  if (wind_used) {
    set.push_back(positive(
        "stress_factor", "1", typical.stress_factor, 0.3, 0.1, 10.0,
        "spread of published drag laws (7 to 14 % between Charnock and the linear law) and "
        "a 10 % error of the wind speed, in quadrature and rounded up"));
  }
  return set;
}

double estimated(const Parameter& parameter, double value) {
  return parameter.is_logarithmic ? std::log(value) : value;
}

double physical(const Parameter& parameter, double estimate) {
  return parameter.is_logarithmic ? std::exp(estimate) : estimate;
}

Prior prior_of(const Parameter& parameter) {
  return {estimated(parameter, parameter.prior), parameter.prior_sigma};
}

}  // namespace slackwater::calibration
