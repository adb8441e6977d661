#include "tests/published/profile_form.h"

#include <string>

#include "calibration/solve/parameter_set.h"
#include "fields/current/coriolis.h"
#include "fields/current/ekman_scale.h"

namespace slackwater::calibration {
namespace {

void add_vector(const std::string& name, const char* unit, double sigma, double bound,
                const char* source, std::vector<Parameter>& set) {
  for (const char* component : {"_east", "_north"}) {
    Parameter p;
    p.name = name + component;
    p.unit = unit;
    p.prior_sigma = sigma;
    p.lower = -bound;
    p.upper = bound;
    p.source = source;
    set.push_back(p);
  }
}

struct LengthPrior {
  const char* name;
  const char* unit;
  double median, log_sigma, lower, upper;
  const char* source;
};

void add_positive(const LengthPrior& prior, std::vector<Parameter>& set) {
  Parameter p;
  p.name = prior.name;
  p.unit = prior.unit;
  p.prior = prior.median;
  p.prior_sigma = prior.log_sigma;
  p.lower = prior.lower;
  p.upper = prior.upper;
  p.is_logarithmic = true;
  p.source = prior.source;
  set.push_back(p);
}

void add_free_scales(Angle latitude, std::vector<Parameter>& set) {
  add_positive({"base_ratio", "1", typical_base_ratio, 0.7, 0.03, 0.6,
                "the step at the base takes a third of the mixed layer's depth, a factor two "
                "either way; own judgement of what a transition layer is"},
               set);
  const double scale_m =
      ekman_scale_m(SteadyParameters{}.eddy_viscosity_m2_s, coriolis_parameter_rad_s(latitude));
  add_positive({"spiral_scale", "m", scale_m, 0.6, 2.0, 150.0,
                "sqrt(2 nu/|f|) with the eddy viscosity of the daily calibration; half its "
                "logarithmic sigma of 1.2"},
               set);
}

}  // namespace

std::string_view name_of(ProfileForm form) noexcept {
  return form == ProfileForm::free_scales ? "free_scales" : "sheared_interior";
}

std::vector<Parameter> profile_parameters(ProfileForm form, Angle latitude) {
  std::vector<Parameter> set;
  add_vector("interior", "m s-1", 1.0, 5.0, "weak: as in the daily calibration", set);
  add_vector("slab", "m s-1", 0.5, 3.0,
             "weak: inertial currents of the mixed layer reach 0.5 m/s after storms (Pollard and "
             "Millard 1970)",
             set);
  add_vector("spiral", "m s-1", 0.5, 3.0,
             "weak: 0.1 to 0.3 m/s for winds of 10 to 20 m/s (Ekman 1905)", set);
  add_positive({"base_depth", "m", 50.0, 1.0, 3.0, 500.0,
                "mixed layers of middle latitudes: 20 m in summer to 200 m and more in winter (de "
                "Boyer Montegut et al. 2004, doi 10.1029/2004JC002378)"},
               set);
  if (form == ProfileForm::free_scales) {
    add_free_scales(latitude, set);
  } else {
    add_vector("shear", "s-1", 1e-3, 0.05,
               "thermal wind g/(rho |f|) times 0.1 kg/m3 of density in 10 km, a strong front", set);
  }
  return set;
}

}  // namespace slackwater::calibration
