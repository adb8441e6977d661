#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "twin/mission/way_round.h"
#include "twin/simulate/aboard.h"
#include "twin/simulate/conduct.h"
#include "twin/simulate/waypoints_home.h"

namespace slackwater::twin {
namespace {

/// A mission without tasks: a route that is put into it is followed, then its end is held.
MissionState nothing_to_do(const Measured& measured) {
  MissionState way = begun(measured);
  way.task = static_cast<std::size_t>(-1);
  way.is_done = true;
  return way;
}

/// One look at everything that the tree asks about, before it is ticked.
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
        own_.is_snagged = is_on;
        if (is_on) snag();
      }
    }
  }

  /// The line is caught where it is nearest to the structure that the vehicle works at, or half on
  /// its way.
  void snag() {
    const auto& nodes = state_.tether.node_m;
    own_.snag_node = nodes.size() / 2;
    if (conduct_.worked_at) {
      const Structure& structure = agent_.water->environment().structures[*conduct_.worked_at];
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
    if (!agent_.tether || !conduct_.worked_at) return;
    const Structure& structure = agent_.water->environment().structures[*conduct_.worked_at];
    const double bearing = from_axis(structure, state_.vehicle.body.position_m).bearing_rad;
    own_.wound_rad += std::remainder(bearing - own_.bearing_rad, 2 * constants::pi);
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
      const double share = limits[i].share(value);
      if (own_.doing == Doing::task && share > own_.most_share) own_.most_share = share;
      if (limits[i].holds(value)) continue;
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

/// What the tree's leaves mean.
class Leaves {
 public:
  Leaves(const Agent& agent, double t_s, AgentState& state)
      : agent_(agent), conduct_(*agent.conduct), t_s_(t_s), state_(state), own_(state.conduct) {}

  bool holds(const Leaf& leaf) {
    const auto condition = static_cast<ConductCondition>(leaf.number);
    const bool holds = answer(condition);
    if (!holds) missing_ = cause_of(condition);
    return holds;
  }

  NodeStatus start(const Leaf& leaf) {
    switch (static_cast<ConductAction>(leaf.number)) {
      case ConductAction::carry_on:
        carry_on();
        break;
      case ConductAction::hold:
        own_.doing = Doing::hold;
        own_.cause = missing_;
        own_.way = nothing_to_do(known_of(agent_, state_));
        tell(ConductEventKind::hold_began);
        return NodeStatus::running;
      case ConductAction::come_home:
        own_.doing = Doing::way_home;
        own_.has_turned = true;
        own_.cause = missing_;
        own_.way = nothing_to_do(known_of(agent_, state_));
        if (!own_.is_aboard)
          replace_waypoints(own_.way, known_of(agent_, state_), waypoints_home(agent_, state_));
        tell(ConductEventKind::turned_for_home);
        break;
    }
    return go_on(leaf);
  }

  NodeStatus go_on(const Leaf& leaf) {
    switch (static_cast<ConductAction>(leaf.number)) {
      case ConductAction::carry_on:
        if (own_.doing == Doing::way_back && !own_.way.is_rerouted) resume();
        return state_.mission.is_done ? NodeStatus::success : NodeStatus::running;
      case ConductAction::hold:
        own_.held_s += conduct_.plan.tick_s;
        return NodeStatus::running;
      case ConductAction::come_home:
        if (own_.way.is_rerouted) return NodeStatus::running;
        tell(ConductEventKind::came_home);
        return NodeStatus::success;
    }
    return NodeStatus::failure;
  }

  /// Where a task is left, it is taken up again, some of its leg twice.
  void halt(const Leaf& leaf) {
    if (static_cast<ConductAction>(leaf.number) != ConductAction::carry_on ||
        own_.doing != Doing::task)
      return;
    const MissionState& mission = state_.mission;
    const Triple<double>& here_m = state_.vehicle.body.position_m;
    own_.left_m = here_m;
    if (mission.route.is_empty() || mission.route.is_done() || !mission.has_begun) return;
    const Triple<double>&from_m = mission.route.from(), to_m = mission.route.to().position_m;
    const LegPlace place = place_on_leg(from_m, to_m, here_m);
    if (!(place.length_m > 0)) return;
    const double along_m =
        std::clamp(place.along_m - conduct_.plan.holding.overlap_m, 0.0, place.length_m);
    own_.left_m = from_m + (along_m / place.length_m) * (to_m - from_m);
  }

 private:
  void tell(ConductEventKind kind) {
    const bool is_limit = own_.cause == Cause::limit;
    own_.events.push_back({t_s_, kind, own_.cause, is_limit ? own_.cause_detail : 0,
                           is_limit ? own_.cause_value : 0});
  }

  [[nodiscard]] bool has_fault(FaultKind kind) const {
    return fault_at(conduct_.plan.faults, kind, t_s_) != nullptr;
  }

  [[nodiscard]] bool are_within_limits() const {
    for (std::size_t i = 0; i < own_.exceeded_s.size(); ++i) {
      if (!conduct_.plan.limits[i].phases.has(own_.phase)) continue;
      const double since_s = t_s_ - own_.exceeded_s[i];
      if (since_s <= 0 || since_s < conduct_.plan.holding.resume_after_s) return false;
    }
    return true;
  }

  [[nodiscard]] bool answer(ConductCondition condition) const {
    switch (condition) {
      case ConductCondition::within_limits:
        return are_within_limits();
      case ConductCondition::reserve_holds: {
        const Reserve& reserve = conduct_.plan.reserve;
        return !(conduct_.full_j > 0) || own_.is_aboard ||
               own_.energy_left_j >=
                   reserve.margin * own_.energy_home_j + reserve.share * conduct_.full_j;
      }
      case ConductCondition::link_up:
        return conduct_.plan.autonomy == Autonomy::automatic || !has_fault(FaultKind::lost_link);
      case ConductCondition::gnss_up:
        return !has_fault(FaultKind::lost_gnss);
      case ConductCondition::thrusters_up:
        return !has_fault(FaultKind::lost_thruster);
      case ConductCondition::tether_free:
        return !own_.is_snagged;
    }
    return false;
  }

  static Cause cause_of(ConductCondition condition) {
    switch (condition) {
      case ConductCondition::within_limits:
        return Cause::limit;
      case ConductCondition::reserve_holds:
        return Cause::reserve;
      case ConductCondition::link_up:
        return Cause::link;
      case ConductCondition::gnss_up:
        return Cause::gnss;
      case ConductCondition::thrusters_up:
        return Cause::thruster;
      case ConductCondition::tether_free:
        return Cause::tether;
    }
    return Cause::none;
  }

  void carry_on() {
    if (own_.doing == Doing::task) return;
    constexpr double near_m = 0.5;
    if (length_of(own_.left_m - state_.vehicle.body.position_m) <= near_m) return resume();
    own_.doing = Doing::way_back;
    own_.way = nothing_to_do(known_of(agent_, state_));
    replace_waypoints(own_.way, known_of(agent_, state_),
                      std::vector<Waypoint>{{own_.left_m, 0, 0}});
    tell(ConductEventKind::went_back);
  }

  void resume() {
    own_.doing = Doing::task;
    tell(ConductEventKind::resumed);
    own_.cause = Cause::none;
  }

  const Agent& agent_;
  const ReadyConduct& conduct_;
  double t_s_;
  AgentState& state_;
  ConductState& own_;
  Cause missing_ = Cause::held_too_long;  ///< the last condition of this tick that did not hold
};

}  // namespace

const char* name_of(ConductEventKind kind) noexcept {
  switch (kind) {
    case ConductEventKind::phase_began:
      return "phase_began";
    case ConductEventKind::hold_began:
      return "hold_began";
    case ConductEventKind::went_back:
      return "went_back";
    case ConductEventKind::resumed:
      return "resumed";
    case ConductEventKind::turned_for_home:
      return "turned_for_home";
    case ConductEventKind::came_home:
      return "came_home";
    case ConductEventKind::came_aboard:
      return "came_aboard";
    case ConductEventKind::launched:
      return "launched";
    case ConductEventKind::fault_began:
      return "fault_began";
    case ConductEventKind::fault_ended:
      return "fault_ended";
    case ConductEventKind::finished:
      return "finished";
    case ConductEventKind::gave_up:
      return "gave_up";
  }
  return "unknown";
}

const char* name_of(Cause cause) noexcept {
  switch (cause) {
    case Cause::none:
      return "none";
    case Cause::limit:
      return "limit";
    case Cause::reserve:
      return "reserve";
    case Cause::link:
      return "lost_link";
    case Cause::gnss:
      return "lost_gnss";
    case Cause::thruster:
      return "lost_thruster";
    case Cause::tether:
      return "fouled_tether";
    case Cause::held_too_long:
      return "held_too_long";
  }
  return "unknown";
}

bool tick_conduct(const Agent& agent, double t_s, AgentState& state, const AgentState* carrier,
                  std::vector<StatusChange>& changes) {
  ConductState& own = state.conduct;
  if (state.halt != Halt::none) return false;
  if (own.has_ended) return own.is_aboard && carry(agent, carrier, state);
  Looker(agent, t_s, state, carrier).look();
  Leaves leaves(agent, t_s, state);
  const NodeStatus status = tick(agent.conduct->plan.behaviour, own.tree, t_s, leaves, changes);
  const bool is_moved = come_and_go(agent, t_s, carrier, state);
  if (status == NodeStatus::running) return is_moved;
  own.has_ended = true;
  const bool is_well = status == NodeStatus::success;
  own.events.push_back(
      {t_s, is_well ? ConductEventKind::finished : ConductEventKind::gave_up, own.cause, 0, 0});
  // What stands on a deck by rights does not hang in the air beside it.
  if (goes_aboard(agent) && !own.is_aboard && is_alongside(agent, carrier, state)) {
    come_aboard(agent, t_s, carrier, state);
    return true;
  }
  return is_moved;
}

}  // namespace slackwater::twin
