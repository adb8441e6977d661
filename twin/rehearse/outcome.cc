#include "twin/rehearse/outcome.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/base/text.h"
#include "twin/simulate/conduct.h"

namespace slackwater::twin {
namespace {

/// A cause in words, without numbers of this flight: those of many are counted by it.
std::string cause_text(const Agent& agent, Cause cause, std::size_t detail) {
  switch (cause) {
    case Cause::limit:
      return "limit: " + text_of(agent.conduct->plan.limits[detail]);
    case Cause::reserve:
      return "energy for the way home";
    case Cause::link:
      return "lost link";
    case Cause::gnss:
      return "lost GNSS";
    case Cause::thruster:
      return "lost thruster";
    case Cause::tether:
      return "fouled tether";
    case Cause::held_too_long:
      return "held too long";
    case Cause::carrier:
      return "its carrier turned for home or went no further";
    case Cause::mammal:
      return "marine mammal in the zone";
    case Cause::no_watch:
      return "nobody has watched the zone for long enough";
    case Cause::none:
      break;
  }
  return "nothing";
}

std::string halt_text(const Agent& agent, const AgentState& state) {
  switch (state.halt) {
    case Halt::struck:
      return "it struck something";
    case Halt::capsized:
      return "it capsized";
    case Halt::aground:
      return "it ran aground";
    case Halt::no_headway:
      return agent.vehicle->kind == VehicleKind::uav ? "the wind was faster than it"
                                                     : "the water was faster than it";
    case Halt::outside_area:
      return "it left the area of the forecast";
    case Halt::outside_time:
      return "the forecast ended";
    case Halt::no_data:
      return "the forecast has a gap";
    default:
      return "it diverged";
  }
}

bool broke_reserve(const Agent& agent, const AgentState& state) {
  const ConductState& own = state.conduct;
  return agent.conduct->full_j > 0 && own.has_ended && !own.is_aboard &&
         own.at_end.charge < agent.conduct->plan.reserve.share;
}

std::string stopped_by(const Agent& agent, const AgentState& state) {
  const ConductState& own = state.conduct;
  const double ended_s = own.has_ended ? own.events.back().t_s : std::numeric_limits<double>::max();
  if (state.milestones.power_lost_s < ended_s)
    return state.milestones.is_empty > 0.5 ? "empty battery"
                                           : "battery cut off at its least voltage";
  if (state.halt != Halt::none) return halt_text(agent, state);
  if (state.milestones.line_parted_s < ended_s) return "its tether parted";
  if (own.has_turned || own.doing == Doing::hold)
    return cause_text(agent, own.cause, own.cause_detail);
  if (!own.has_ended || !state.mission.is_done) return "out of time";
  return broke_reserve(agent, state) ? "reserve broken" : "";
}

bool had_cause(const ConductState& own, Cause cause) {
  return std::any_of(own.events.begin(), own.events.end(),
                     [&](const ConductEvent& event) { return event.cause == cause; });
}

/// @param out  all else of the outcome
RiskCauses risk_causes_of(const Agent& agent, const AgentState& state, const VehicleOutcome& out) {
  RiskCauses set;
  if (out.worst_share > 1) set.add(RiskCause::limit);
  if (agent.conduct) {
    const ConductState& own = state.conduct;
    if (had_cause(own, Cause::reserve) || broke_reserve(agent, state)) set.add(RiskCause::energy);
    if (had_cause(own, Cause::tether)) set.add(RiskCause::tether);
    if (had_cause(own, Cause::limit)) set.add(RiskCause::limit);
  }
  if (state.milestones.power_lost_s < out.ended_s) set.add(RiskCause::energy);
  if (out.line_parted_s && *out.line_parted_s < out.ended_s) set.add(RiskCause::tether);
  if (state.halt == Halt::no_headway || state.halt == Halt::capsized) set.add(RiskCause::station);
  if (state.halt == Halt::struck || state.halt == Halt::aground ||
      out.clearance_alarms.value_or(0) > 0)
    set.add(RiskCause::collision);
  if (!out.is_done && set.none()) set.add(RiskCause::work);
  return set;
}

/// All it did, and the face is not clean for all that.
std::string left_text(const CleaningOutcome& cleaning) {
  if (cleaning.is_done()) return "";
  return formatted("less than {:g} % of the surface is clean", 100 * cleaning.done_at);
}

}  // namespace

VehicleOutcome outcome_of(const Agent& agent, const AgentState& state, double ran_s) {
  VehicleOutcome out;
  out.name = agent.name;
  out.energy_j = state.vehicle.drawn_j;
  out.fuel_kg = state.vehicle.fuel_kg;
  out.state_of_charge = state.vehicle.battery.charge;
  out.nearest = state.nearest;
  out.thrust_used = state.thrust.most;
  if (agent.tether) out.line_used = state.milestones.most_line_n / agent.tether->breaking_load_n;
  if (!std::isnan(state.milestones.line_parted_s))
    out.line_parted_s = state.milestones.line_parted_s;
  if (agent.clearance) out.clearance_alarms = state.clearance.alarms;
  out.ended_s = state.halt != Halt::none ? state.halted_at_s : ran_s;
  const std::size_t tasks = agent.mission.tasks.size();
  out.work_share = tasks > 0 ? static_cast<double>(std::min(state.mission.task, tasks)) /
                                   static_cast<double>(tasks)
                             : 1;
  if (!agent.conduct) {
    out.is_done = state.halt == Halt::none;
    if (!out.is_done) out.stopped_by = halt_text(agent, state);
    out.risks = risk_causes_of(agent, state, out);
    return out;
  }
  const ConductState& own = state.conduct;
  if (own.has_ended) {
    out.energy_j = own.at_end.drawn_j;
    out.fuel_kg = own.at_end.fuel_kg;
    out.state_of_charge = own.at_end.charge;
  }
  out.held_s = own.held_s;
  out.worst_share = own.most_share;
  out.least_charge = own.least_charge;
  out.events = own.events;
  out.searches = agent.conduct->plan.search.has_value();
  if (own.search.is_found) out.found_s = own.search.found_s;
  if (own.has_ended && !own.events.empty()) out.ended_s = own.events.back().t_s;
  out.stopped_by = stopped_by(agent, state);
  if (const auto& cleaning = agent.conduct->cleaning) {
    out.cleaning = cleaning_outcome(*cleaning, own.cleaning);
    if (out.stopped_by.empty()) out.stopped_by = left_text(*out.cleaning);
  }
  if (agent.inspection) {
    out.inspection = inspection_outcome(*agent.inspection, state.inspection);
    if (out.stopped_by.empty()) out.stopped_by = out.inspection->left;
  }
  out.is_done = out.stopped_by.empty();
  out.risks = risk_causes_of(agent, state, out);
  return out;
}

std::string text_of(const ConductEvent& event, const Agent& agent) {
  const auto because = [&](const char* what) {
    std::string text = std::string(what) + ": " + cause_text(agent, event.cause, event.detail);
    if (event.cause == Cause::limit)
      text += std::isnan(event.value) ? std::string(", found no value")
                                      : formatted(", found {:.3g}", event.value);
    return text;
  };
  switch (event.kind) {
    case ConductEventKind::phase_began:
      return name_of(static_cast<Phase>(event.detail));
    case ConductEventKind::hold_began:
      return because("holds");
    case ConductEventKind::went_back:
      return "goes back to where it left off";
    case ConductEventKind::resumed:
      return "resumes";
    case ConductEventKind::turned_for_home:
      return because("comes home");
    case ConductEventKind::came_home:
      return "home";
    case ConductEventKind::came_aboard:
      return "aboard";
    case ConductEventKind::launched:
      return "launched";
    case ConductEventKind::fault_began:
    case ConductEventKind::fault_ended:
      return std::string(event.kind == ConductEventKind::fault_began ? "fault: " : "over: ") +
             name_of(agent.conduct->plan.faults[event.detail].kind);
    case ConductEventKind::finished:
      return "finished";
    case ConductEventKind::gave_up:
      return "gave up";
    case ConductEventKind::found:
      return formatted("finds who it looks for, {:.0f} m off", event.value);
  }
  return "";
}

}  // namespace slackwater::twin
