#include <algorithm>
#include <cmath>
#include <limits>

#include "twin/agent/conduct.h"
#include "twin/agent/waypoints_home.h"
#include "twin/body/frame.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

constexpr double unmade_s = std::numeric_limits<double>::infinity();

/// The water, or the wind of one that flies, half on the way.
Triple<double> stream_on_the_way(const Agent& agent, const Triple<double>& from_m,
                                 const Triple<double>& to_m, double t_s) {
  const Triple<double> middle_m = 0.5 * (from_m + to_m);
  if (agent.vehicle->kind == VehicleKind::uav) return agent.water->wind(middle_m, t_s).velocity_m_s;
  const Triple<double> in_water{middle_m.x, middle_m.y, std::max(middle_m.z, 0.0)};
  return agent.water->current(in_water, agent.vehicle->body.height_m, t_s).current_m_s;
}

/// Speed over ground along a way for one that makes `own_m_s` through a stream and may head into
/// it; 0 or less: it is carried off.
double speed_made_good(double own_m_s, double along_m_s, double across_m_s) {
  const double left2 = own_m_s * own_m_s - across_m_s * across_m_s;
  return left2 < 0 ? 0 : along_m_s + std::sqrt(left2);
}

}  // namespace

double cruise_w_at(const ReadyConduct& conduct, double speed_m_s) noexcept {
  const std::vector<double>& table = conduct.cruise_w;
  const double at = speed_m_s / conduct.speed_step_m_s;
  const auto low = std::min(static_cast<std::size_t>(at), table.size() - 2);
  return table[low] + (at - static_cast<double>(low)) * (table[low + 1] - table[low]);
}

bool reserve_holds(const ReadyConduct& conduct, const ConductState& state) noexcept {
  const Reserve& reserve = conduct.plan.reserve;
  return !(conduct.full_j > 0) || state.energy_left_j >= reserve.margin * state.energy_home_j +
                                                             reserve.share * conduct.full_j;
}

std::vector<Waypoint> waypoints_home(const Agent& agent, const AgentState& state) {
  const ReadyConduct& conduct = *agent.conduct;
  const auto& structures = agent.water->environment().structures;
  const Triple<double>& from_m = state.vehicle.body.position_m;
  const Triple<double> home_m = agent.carrier ? state.conduct.boarding_m : conduct.home_m;
  const double clear_m = conduct.plan.clear_m;
  const ConductState& own = state.conduct;
  if (agent.tether && own.worked_at != ConductState::no_structure &&
      std::abs(own.wound_rad) > constants::pi / 2)
    return way_unwound(from_m, home_m, structures[own.worked_at], own.wound_rad, clear_m);
  return way_round(from_m, home_m, structures, clear_m);
}

WayHome way_home(const Agent& agent, double t_s, const AgentState& state) {
  const ReadyConduct& conduct = *agent.conduct;
  const Guidance& guidance = agent.mission.guidance;
  const bool by_ground = agent.vehicle->kind == VehicleKind::uav ||
                         agent.vehicle->kind == VehicleKind::rov || guidance.is_over_ground;
  WayHome out;
  Triple<double> from_m = state.vehicle.body.position_m;
  for (const Waypoint& waypoint : waypoints_home(agent, state)) {
    const Triple<double> leg = waypoint.position_m - from_m;
    const double length_m = length_of(leg);
    if (length_m > 1e-6) {
      const Triple<double> stream = stream_on_the_way(agent, from_m, waypoint.position_m, t_s);
      const Triple<double> way = (1 / length_m) * leg;
      const double along_m_s = dot(stream, way);
      const double across_m_s = length_of(stream - along_m_s * way);
      double own_m_s =
          by_ground ? std::hypot(guidance.speed_m_s - along_m_s, across_m_s) : guidance.speed_m_s;
      own_m_s = std::min(own_m_s, conduct.top_speed_m_s);
      const double made_m_s = speed_made_good(own_m_s, along_m_s, across_m_s);
      const double time_s = made_m_s > 0.01 ? length_m / made_m_s : unmade_s;
      out.length_m += length_m;
      out.time_s += time_s;
      out.energy_j += time_s * (cruise_w_at(conduct, own_m_s) + state.conduct.extra_power_w);
    }
    from_m = waypoint.position_m;
  }
  return out;
}

double steady_power_w(const Agent& agent, const AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  const Triple<double> over_ground = rotation_of(body.attitude).to_ned(body.nu.linear);
  const bool flies = agent.vehicle->kind == VehicleKind::uav;
  return cruise_w_at(*agent.conduct,
                     length_of(over_ground - (flies ? state.wind_m_s : state.water_m_s)));
}

}  // namespace slackwater::twin
