#include <algorithm>

#include "twin/agent/aboard.h"
#include "twin/agent/conduct.h"
#include "twin/agent/follow_datum.h"
#include "twin/agent/helm.h"
#include "twin/agent/hung_line.h"
#include "twin/agent/keep_lookout.h"
#include "twin/agent/look_about.h"
#include "twin/agent/waypoints_home.h"

namespace slackwater::twin {
namespace {

/// What the tree's leaves mean.
class Leaves {
 public:
  Leaves(const Agent& agent, double t_s, const Company& company, AgentState& state)
      : agent_(agent),
        conduct_(*agent.conduct),
        t_s_(t_s),
        company_(company),
        state_(state),
        own_(state.conduct) {}

  bool holds(const Leaf& leaf) {
    const auto condition = static_cast<ConductCondition>(leaf.number);
    const bool holds = answer(condition);
    if (!holds) missing_ = cause_of(condition);
    if (missing_ == Cause::limit && !holds && are_limits_kept())
      missing_ = own_.noisy.is_seen ? Cause::mammal : Cause::no_watch;
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
        own_.waits_for_line = true;
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
        // It does not leave with a line in the water, also not with one that was launched as it
        // turned.
        if (company_.has_line_out) {
          if (!own_.waits_for_line) own_.way = nothing_to_do(known_of(agent_, state_));
          own_.waits_for_line = true;
          return NodeStatus::running;
        }
        if (own_.waits_for_line) set_out_for_home();
        own_.waits_for_line = false;
        if (own_.way.is_rerouted) return NodeStatus::running;
        // Its carrier lies where it lies by now, and does not leave without it.
        if (hangs_from_a_deck() && !is_alongside(agent_, company_.carrier, state_)) {
          replace_waypoints(own_.way, known_of(agent_, state_),
                            std::vector<Waypoint>{{own_.boarding_m, 0, 0}});
          return NodeStatus::running;
        }
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
    const Triple<double> here_m = state_.vehicle.body.position_m - mission.offset_m;
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
  void set_out_for_home() {
    if (!own_.is_aboard)
      replace_waypoints(own_.way, known_of(agent_, state_), waypoints_home(agent_, state_));
  }

  [[nodiscard]] bool hangs_from_a_deck() const {
    return agent_.tether && agent_.carrier && has_line_out(agent_, state_);
  }

  void tell(ConductEventKind kind) {
    const bool is_limit = own_.cause == Cause::limit;
    own_.events.push_back({t_s_, kind, own_.cause, is_limit ? own_.cause_detail : 0,
                           is_limit ? own_.cause_value : 0});
  }

  [[nodiscard]] bool has_fault(FaultKind kind) const {
    return fault_at(conduct_.plan.faults, kind, t_s_) != nullptr;
  }

  /// Noise is made under a watch of its zone alone.
  [[nodiscard]] bool may_make_noise() const {
    return !agent_.zone || own_.phase != Phase::work || own_.noisy.is_clear;
  }

  [[nodiscard]] bool are_limits_kept() const {
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
        return are_limits_kept() && may_make_noise();
      case ConductCondition::reserve_holds:
        return own_.is_aboard || twin::reserve_holds(conduct_, own_);
      case ConductCondition::carrier_stays:
        return !agent_.tether || !company_.carrier_is_gone;
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
      case ConductCondition::carrier_stays:
        return Cause::carrier;
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
    Triple<double> left_m = own_.left_m;
    if (drifts(agent_.mission, state_.mission))
      left_m = left_m + datum_frame(agent_, state_, t_s_).offset_m;
    if (length_of(left_m - state_.vehicle.body.position_m) <= near_m) return resume();
    own_.doing = Doing::way_back;
    own_.way = nothing_to_do(known_of(agent_, state_));
    replace_waypoints(own_.way, known_of(agent_, state_), std::vector<Waypoint>{{left_m, 0, 0}});
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
  const Company& company_;
  AgentState& state_;
  ConductState& own_;
  Cause missing_ = Cause::held_too_long;  ///< the last condition of this tick that did not hold
};

/// Its work is what is heard.
bool is_noisy(const AgentState& state) {
  const ConductState& own = state.conduct;
  return own.phase == Phase::work && own.doing == Doing::task && !own.has_ended && moves(state) &&
         !state.helm.is_helmed();
}

/// Under the helm: looks about as ever, and is taken back where it must come home.
/// @return whether its tree goes on
bool is_free_of_helm(const Agent& agent, double t_s, const AgentState* carrier, AgentState& state) {
  if (!state.helm.is_helmed()) return true;
  keep_boarding_place(agent, carrier, state);
  if (agent.zone) note_noise(false, t_s, state.conduct.noisy);
  const bool is_on_its_way = state.helm.mode == HelmMode::home;
  if (is_on_its_way || !must_come_home(agent, state)) return false;
  if (!state.conduct.has_ended) {
    give_back(HelmCause::reserve, t_s, agent, state);
    return true;
  }
  take_helm({HelmMode::home, HelmCause::reserve}, t_s, agent, state);
  return false;
}

/// A carrier goes on when those that it carries are back, with no line in the water.
void go_on_from_a_stand(const Agent& agent, const Company& company, AgentState& state) {
  const auto& tasks = agent.mission.tasks;
  if (state.conduct.doing != Doing::task || state.mission.task >= tasks.size() ||
      tasks[state.mission.task].kind != ScenarioTask::Kind::stand_by)
    return;
  if (company.are_back && !company.has_line_out) end_task(agent.mission, state.mission);
}

}  // namespace

bool tick_conduct(const Agent& agent, double t_s, AgentState& state, const Company& company,
                  std::vector<StatusChange>& changes) {
  ConductState& own = state.conduct;
  const AgentState* const carrier = company.carrier;
  if (state.halt != Halt::none) return false;
  if (own.has_ended && !state.helm.is_helmed())
    return own.is_aboard && carry(agent, carrier, state);
  keep_lookout(agent, t_s, state);
  follow_datum(agent, t_s, state);
  look_about(agent, t_s, state, carrier);
  if (!is_free_of_helm(agent, t_s, carrier, state)) return false;
  Leaves leaves(agent, t_s, company, state);
  const NodeStatus status = tick(agent.conduct->plan.behaviour, own.tree, t_s, leaves, changes);
  const bool is_moved = come_and_go(agent, t_s, company, state);
  go_on_from_a_stand(agent, company, state);
  own.has_ended = status != NodeStatus::running;
  if (agent.zone) note_noise(is_noisy(state), t_s, own.noisy);
  if (!own.has_ended) return is_moved;
  own.at_end = {state.vehicle.drawn_j, state.vehicle.fuel_kg, state.vehicle.battery.charge};
  const bool is_well = status == NodeStatus::success;
  own.events.push_back(
      {t_s, is_well ? ConductEventKind::finished : ConductEventKind::gave_up, own.cause, 0, 0});
  return recover(agent, t_s, carrier, state) || is_moved;
}

}  // namespace slackwater::twin
