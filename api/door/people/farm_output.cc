#include "api/door/people/farm_output.h"

#include "twin/render/scene/turning_rotor.h"

namespace slackwater::people {
namespace {

/// 0.1 m/s is 3 % of the power at 10 m/s, below what is read off a page; of the direction likewise.
constexpr double as_good_as_m_s = 0.1;

}  // namespace

FarmNow FarmOutput::at(Horizontal hub_wind_m_s) {
  if (worked_out_for_m_s_ && std::abs(hub_wind_m_s - *worked_out_for_m_s_) < as_good_as_m_s)
    return now_;
  const Turbine& kind = *turbines_.kind;
  const FarmFlow flow(kind, turbines_.at_m, hub_wind_m_s, FarmSettings{});
  worked_out_for_m_s_ = hub_wind_m_s;
  now_.power_w = flow.power_w();
  now_.rated_w = kind.rated_power_w * static_cast<double>(turbines_.at_m.size());
  now_.turbines.clear();
  const double speed_m_s = std::abs(hub_wind_m_s);
  for (const TurbineFlow& felt : flow.turbines()) {
    TurbineNow turbine{felt.power_w, felt.inflow_speed_m_s,
                       twin::rotor_speed_rad_s(kind, felt.inflow_speed_m_s)};
    for (std::size_t i = 0; i < behind_diameters.size(); ++i) {
      const double behind_m = behind_diameters[i] * kind.rotor_diameter_m;
      turbine.wind_left[i] =
          speed_m_s > 0 ? flow.speed_ratio(felt.position_m + behind_m / speed_m_s * hub_wind_m_s,
                                           kind.hub_height_m)
                        : 1;
    }
    now_.turbines.push_back(turbine);
  }
  return now_;
}

}  // namespace slackwater::people
