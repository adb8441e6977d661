#include "api/door/live/topics/reserve_advice.h"

#include <cmath>
#include <limits>

#include "fields/base/constants.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/agent/waypoints_home.h"
#include "twin/battery/battery.h"

namespace slackwater::live {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Energy of the straight way to where it began; infinite where the water is faster than it.
double straight_home_j(const twin::Agent& agent, const twin::AgentState& state,
                       const twin::Triple<double>& start_m, double t_s, double power_w) {
  const twin::Triple<double>& from_m = state.vehicle.body.position_m;
  const twin::Triple<double> way = start_m - from_m;
  const double length_m = twin::length_of(way);
  if (length_m < 1) return 0;
  twin::Triple<double> stream;
  if (agent.vehicle->kind == twin::VehicleKind::uav) {
    stream = agent.water->wind(from_m, t_s).velocity_m_s;
  } else {
    const twin::Triple<double> wet_m{from_m.x, from_m.y, std::max(from_m.z, 0.0)};
    stream = agent.water->current(wet_m, agent.vehicle->body.height_m, t_s).current_m_s;
  }
  const double along_m_s = twin::dot(stream, way) / length_m;
  const double across2 = twin::dot(stream, stream) - along_m_s * along_m_s;
  const double own_m_s = agent.vehicle->cruise_speed_m_s;
  const double left2 = own_m_s * own_m_s - across2;
  const double made_m_s = left2 > 0 ? along_m_s + std::sqrt(left2) : 0;
  return made_m_s > 0.01 ? length_m / made_m_s * power_w : never;
}

}  // namespace

ReserveAdvice::ReserveAdvice(const twin::AgentState& at_start, double t_s)
    : start_m_(at_start.vehicle.body.position_m),
      looked_s_(t_s),
      drawn_j_(at_start.vehicle.drawn_j) {}

dds::Reserve ReserveAdvice::look(const twin::Agent& agent, const twin::AgentState& state,
                                 UtcTime now, double t_s) {
  dds::Reserve reserve;
  const auto& battery = agent.vehicle->battery;
  if (!battery) {
    reserve.energy_left_j = reserve.energy_home_j = reserve.margin_s = constants::nan;
    reserve.advice = "it burns fuel: no reserve is computed";
    return reserve;
  }
  // The power of the last minute, so that a moment's effort does not call it home.
  constexpr double memory_s = 60;
  if (const double dt_s = t_s - looked_s_; dt_s > 0) {
    const double mean_w = (state.vehicle.drawn_j - drawn_j_) / dt_s;
    const double take = power_w_ < 0 ? 1 : 1 - std::exp(-dt_s / memory_s);
    power_w_ = std::max(power_w_, 0.0) * (1 - take) + take * mean_w;
    looked_s_ = t_s;
    drawn_j_ = state.vehicle.drawn_j;
  }
  const double power_w = std::max(power_w_, agent.vehicle->hotel_w);
  const twin::Reserve rule = agent.conduct ? agent.conduct->plan.reserve : twin::Reserve();
  const double full_j = twin::open_circuit_energy_j(*battery, 1, 0);
  reserve.energy_left_j = twin::open_circuit_energy_j(*battery, state.vehicle.battery.charge, 0);
  reserve.energy_home_j = agent.conduct ? twin::way_home(agent, t_s, state).energy_j
                                        : straight_home_j(agent, state, start_m_, t_s, power_w);
  const double spare_j =
      reserve.energy_left_j - rule.margin * reserve.energy_home_j - rule.share * full_j;
  reserve.margin_s = power_w > 0 ? spare_j / power_w : never;
  reserve.advice = advice_of(reserve.margin_s, now);
  return reserve;
}

std::string advice_of(double margin_s, UtcTime now) {
  if (std::isnan(margin_s)) return "no reserve is computed";
  if (margin_s <= 0) {
    return std::isinf(margin_s) ? "it cannot come home: the current is faster than the vehicle"
                                : "come home now: the reserve is needed";
  }
  constexpr double longest_s = 30.0 * 86400;
  if (margin_s > longest_s) return "it need not come home within a month";
  const auto left = Duration(static_cast<Duration::rep>(margin_s) * 1000);
  return "come home by " + format_utc(std::chrono::floor<std::chrono::seconds>(now + left));
}

}  // namespace slackwater::live
