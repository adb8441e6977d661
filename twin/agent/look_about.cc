#include "twin/agent/look_about.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "twin/agent/conduct.h"
#include "twin/agent/waypoints_home.h"
#include "twin/body/frame.h"
#include "twin/mission/way_round.h"

namespace slackwater::twin {
namespace {

class Looker {
 public:
  Looker(const Agent& agent, double t_s, AgentState& state, const AgentState* carrier)
      : agent_(agent),
        conduct_(*agent.conduct),
        t_s_(t_s),
        state_(state),
        own_(state.conduct),
        carrier_(carrier) {}

  void look() {
    look_at_faults();
    look_at_phase();
    look_at_power();
    look_at_winding();
    look_at_deck();
    look_at_limits();
  }

 private:
  void tell(ConductEventKind kind, std::size_t detail) {
    own_.events.push_back({t_s_, kind, Cause::none, detail, 0});
  }

  void look_at_faults() {
    const std::vector<Fault>& faults = conduct_.plan.faults;
    for (std::size_t i = 0; i < faults.size(); ++i) {
      const bool is_on = faults[i].is_on(t_s_);
      if (is_on == (own_.faults[i] != 0)) continue;
      own_.faults[i] = is_on ? 1 : 0;
      tell(is_on ? ConductEventKind::fault_began : ConductEventKind::fault_ended, i);
      if (faults[i].kind == FaultKind::fouled_tether) {
        // A line aboard is caught nowhere.
        own_.is_snagged = is_on && !own_.is_aboard;
        if (own_.is_snagged) snag();
      }
    }
  }

  /// The line is caught where it is nearest to the structure that the vehicle works at, or half on
  /// its way.
  void snag() {
    const auto& nodes = state_.tether.node_m;
    own_.snag_node = nodes.size() / 2;
    if (own_.worked_at != ConductState::no_structure) {
      const Structure& structure = agent_.water->environment().structures[own_.worked_at];
      for (std::size_t i = 0; i < nodes.size(); ++i)
        if (signed_distance_m(structure, nodes[i]) <
            signed_distance_m(structure, nodes[own_.snag_node]))
          own_.snag_node = i;
    }
    own_.snag_m = nodes[own_.snag_node];
  }

  void look_at_phase() {
    const std::vector<ScenarioTask>& tasks = agent_.mission.tasks;
    Phase phase = Phase::return_home;
    if (state_.helm.is_helmed()) return;  // what it does then is of no phase
    if (own_.doing != Doing::way_home && state_.mission.task < tasks.size())
      phase = tasks[state_.mission.task].phase;
    if (phase == own_.phase && own_.drawn_j + t_s_ > 0) return;
    own_.phase = phase;
    tell(ConductEventKind::phase_began, static_cast<std::size_t>(phase));
  }

  void look_at_power() {
    constexpr double memory_s = 60;
    const double drawn_j = state_.vehicle.drawn_j;
    const double tick_s = conduct_.plan.tick_s;
    const double take = 1 - std::exp(-tick_s / memory_s);
    // Over the tick before: none before the first.
    const double mean_w = t_s_ > 0 ? (drawn_j - own_.drawn_j) / tick_s : 0;
    const double extra_w = std::max(mean_w - steady_power_w(agent_, state_), 0.0);
    own_.extra_power_w += take * (extra_w - own_.extra_power_w);
    own_.drawn_j = drawn_j;
    own_.least_charge = std::min(own_.least_charge, state_.vehicle.battery.charge);
    if (!(conduct_.full_j > 0) || own_.is_aboard) return;
    own_.energy_left_j =
        open_circuit_energy_j(*agent_.vehicle->battery, state_.vehicle.battery.charge, 0);
    own_.energy_home_j = way_home(agent_, t_s_, state_).energy_j;
  }

  void look_at_winding() {
    // A line aboard winds about nothing.
    if (!agent_.tether || own_.worked_at == ConductState::no_structure || own_.is_aboard) return;
    const Structure& structure = agent_.water->environment().structures[own_.worked_at];
    const double bearing = from_axis(structure, state_.vehicle.body.position_m).bearing_rad;
    own_.wound_rad += short_way_rad(bearing - own_.bearing_rad);
    own_.bearing_rad = bearing;
  }

  void look_at_deck() {
    if (!carrier_ && !conduct_.plan.deck_point_m) return;
    // That of its carrier, where it has one.
    const BodyState<double>& body = (carrier_ ? *carrier_ : state_).vehicle.body;
    const Rotation<double> r = rotation_of(body.attitude);
    const Triple<double>& point_m = carrier_ ? agent_.deck_m : *conduct_.plan.deck_point_m;
    own_.deck.look(body.position_m.z + r.to_ned(point_m).z,
                   r.to_ned(body.nu.linear + cross(body.nu.angular, point_m)).z,
                   conduct_.plan.tick_s);
  }

  void look_at_limits() {
    const std::vector<Limit>& limits = conduct_.plan.limits;
    double worst = 0;
    for (std::size_t i = 0; i < limits.size(); ++i) {
      if (!limits[i].phases.has(own_.phase)) continue;
      const double value = value_of(limits[i], agent_, t_s_, state_);
      if (std::isnan(value) && limits[i].may_be_missing) continue;
      const double bound = bound_of(limits[i], agent_, t_s_, state_);
      const double share = limits[i].share(value, bound);
      if (own_.doing == Doing::task && !state_.helm.is_helmed() && share > own_.most_share)
        own_.most_share = share;
      if (limits[i].holds(value, bound)) continue;
      own_.exceeded_s[i] = t_s_;
      if (worst > 0 && !(share > worst)) continue;
      worst = share;
      own_.cause_detail = i;
      own_.cause_value = value;
    }
  }

  const Agent& agent_;
  const ReadyConduct& conduct_;
  double t_s_;
  AgentState& state_;
  ConductState& own_;
  const AgentState* carrier_;
};

}  // namespace

void look_about(const Agent& agent, double t_s, AgentState& state, const AgentState* carrier) {
  Looker(agent, t_s, state, carrier).look();
}

}  // namespace slackwater::twin
