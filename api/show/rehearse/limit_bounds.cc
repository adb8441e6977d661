#include "api/show/rehearse/limit_bounds.h"

#include <nlohmann/json.hpp>

namespace slackwater::api {

nlohmann::json limit_bounds_json(const twin::ScenarioVehicle& vehicle) {
  nlohmann::json bounds = nlohmann::json::object();
  if (!vehicle.conduct) return bounds;
  for (const twin::Limit& limit : vehicle.conduct->limits) {
    const char* name = nullptr;
    switch (limit.variable) {
      case twin::LimitVariable::current_speed:
        name = "current";
        break;
      case twin::LimitVariable::wind_speed:
      case twin::LimitVariable::wind_speed_10m:
        name = "wind";
        break;
      case twin::LimitVariable::significant_wave_height:
        name = "waves";
        break;
      default:
        break;
    }
    // A bound that goes by the sea is no line across a chart.
    if (name == nullptr || limit.is_least || limit.table) continue;
    if (!bounds.contains(name) || bounds[name].get<double>() > limit.bound)
      bounds[name] = limit.bound;
  }
  return bounds;
}

}  // namespace slackwater::api
