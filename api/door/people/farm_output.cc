#include "api/door/people/farm_output.h"

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
  now_.turbines = turbines_.at_m.size();
  now_.rated_w = kind.rated_power_w * static_cast<double>(now_.turbines);
  return now_;
}

}  // namespace slackwater::people
