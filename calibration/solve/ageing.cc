#include "calibration/solve/ageing.h"

#include <algorithm>
#include <cmath>

#include "calibration/solve/parameter_set.h"

namespace slackwater::calibration {
namespace {

/// 0 for what is not carried over.
double daily_growth(const std::string& name, const Ageing& ageing) {
  if (name == "eddy_viscosity" || name == "bottom_eddy_viscosity") return ageing.eddy_viscosity;
  if (name == "mixed_layer_depth") return ageing.mixed_layer_depth;
  if (name == "bottom_friction" || name == "base_friction") return ageing.friction;
  if (name == "stress_factor") return ageing.stress_factor;
  return 0;
}

}  // namespace

std::vector<KnownParameter> aged(const Calibration& earlier, double days_between,
                                 const Ageing& ageing) {
  std::vector<KnownParameter> known;
  const std::vector<Parameter> general =
      prior_parameters(earlier.layout, earlier.water_depth_m, {});
  for (std::size_t i = 0; i < earlier.parameters.size(); ++i) {
    const Parameter& p = earlier.parameters[i];
    const double growth = daily_growth(p.name, ageing);
    if (growth <= 0) continue;
    const double posterior = p.sigma * p.sigma;
    const double limit = general[i].prior_sigma * general[i].prior_sigma;
    const double walked = posterior + growth * growth * days_between;
    // The walk forgets: its variance stays below the general prior's, and the mean returns with it.
    const double share = std::clamp((walked - posterior) / std::max(limit, walked), 0.0, 1.0);
    const double mean =
        (1.0 - share) * estimated(p, p.value) + share * estimated(p, general[i].prior);
    known.push_back({p.name, physical(p, mean), std::sqrt(std::min(walked, limit))});
  }
  return known;
}

}  // namespace slackwater::calibration
