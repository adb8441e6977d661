#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/wind/dryden_gust.h"
#include "fields/wind/gust.h"
#include "twin/agent/conduct.h"
#include "twin/body/frame.h"

namespace slackwater::twin {
namespace {

double wind_m_s(const Agent& agent, Triple<double> at_m, double down_m, double t_s) {
  at_m.z = down_m;
  const auto wind = agent.water->wind(at_m, t_s);
  return has_value(wind.status) ? std::hypot(wind.velocity_m_s.x, wind.velocity_m_s.y)
                                : constants::nan;
}

/// What a gust of three seconds reaches within ten minutes, by the turbulence that vehicles fly in.
double gust_m_s(const Agent& agent, const Triple<double>& at_m, double down_m, double t_s) {
  constexpr double twenty_feet_m = 6.096;
  const double mean_m_s = wind_m_s(agent, at_m, down_m, t_s);
  const double low_m_s = wind_m_s(agent, at_m, -twenty_feet_m, t_s);
  const double sigma_m_s = dryden_turbulence(-down_m, low_m_s).sigma_horizontal_m_s;
  return mean_m_s > 0 ? mean_m_s * gust_factor(sigma_m_s / mean_m_s) : mean_m_s;
}

double assumed(const ReadyConduct& conduct, LimitVariable variable) {
  for (const Assumption& assumption : conduct.plan.assumed)
    if (assumption.variable == variable) return assumption.value;
  return constants::nan;
}

}  // namespace

double value_of(const Limit& limit, const Agent& agent, double t_s, const AgentState& state) {
  const Triple<double>& at_m = state.vehicle.body.position_m;
  const double down_m = limit.down_m.value_or(at_m.z);
  switch (limit.variable) {
    case LimitVariable::significant_wave_height:
    case LimitVariable::wave_peak_period: {
      const SeaSample sample = agent.water->sea(at_m, t_s);
      // Of a sea that is missing what is known counts: a height without its period is a height.
      if (!has_value(sample.status) && sample.status != SampleStatus::missing)
        return constants::nan;
      const SeaState& sea = sample.sea;
      if (limit.waves && !std::isnan(sea.significant_height_m) &&
          !limit.waves->holds(sea, euler_angles(state.vehicle.body.attitude).yaw_rad))
        return 0;
      return limit.variable == LimitVariable::wave_peak_period ? sea.peak_period_s
                                                               : sea.significant_height_m;
    }
    case LimitVariable::wind_speed_10m:
      return wind_m_s(agent, at_m, -10, t_s);
    case LimitVariable::wind_speed:
      return wind_m_s(agent, at_m, std::min(down_m, -2.0), t_s);
    case LimitVariable::gust_speed:
      return gust_m_s(agent, at_m, std::min(down_m, -2.0), t_s);
    case LimitVariable::current_speed: {
      const CurrentSample current =
          agent.water->forecast_current({at_m.x, at_m.y, std::max(down_m, 0.0)}, t_s);
      return has_value(current.status) ? std::abs(current.velocity_m_s) : constants::nan;
    }
    case LimitVariable::deck_motion:
      return agent.carrier || agent.conduct->plan.deck_point_m ? state.conduct.deck.significant_m()
                                                               : constants::nan;
    case LimitVariable::fender_force:
      return agent.conduct->bow_mass_kg > 0
                 ? agent.conduct->bow_mass_kg * state.conduct.deck.significant_acceleration_m_s2()
                 : constants::nan;
    case LimitVariable::sea_surface_height: {
      const SeaLevelSample level = agent.water->sea_level(at_m, t_s);
      return has_value(level.status) ? level.level_m : assumed(*agent.conduct, limit.variable);
    }
    case LimitVariable::visibility:
      return agent.water->visibility_m().value_or(assumed(*agent.conduct, limit.variable));
    case LimitVariable::water_visibility:
      return agent.water->water_visibility_m().value_or(assumed(*agent.conduct, limit.variable));
    case LimitVariable::rain_rate:
    case LimitVariable::air_temperature:
      return assumed(*agent.conduct, limit.variable);
  }
  return constants::nan;
}

HeightBound height_bound_of(const HeightTable& table, const Agent& agent, double t_s,
                            const AgentState& state) {
  return table.limit_at(agent.water->sea(state.vehicle.body.position_m, t_s).sea,
                        euler_angles(state.vehicle.body.attitude).yaw_rad);
}

double bound_of(const Limit& limit, const Agent& agent, double t_s, const AgentState& state) {
  return limit.table ? height_bound_of(*limit.table, agent, t_s, state).at_most_m : limit.bound;
}

}  // namespace slackwater::twin
