#include "twin/account/vehicle_account.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "fields/base/text.h"
#include "twin/agent/aboard.h"
#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

Makeup makeup_of(const Agent& agent) {
  Makeup makeup;
  makeup.has_battery = agent.vehicle->battery.has_value();
  makeup.burns_fuel = burns_fuel(*agent.vehicle);
  makeup.is_electric = makeup.has_battery || !makeup.burns_fuel || agent.vehicle->hotel_w > 0;
  makeup.floats = agent.vehicle->body.hull.strips > 0;
  makeup.flies = agent.vehicle->kind == VehicleKind::uav;
  makeup.by_sensors = agent.navigation && agent.navigation->steers;
  makeup.has_conduct = agent.conduct != nullptr;
  makeup.searches = agent.conduct && agent.conduct->plan.search.has_value();
  return makeup;
}

std::optional<Approach> named(const NearestPass& pass, std::string to) {
  if (!pass.is_any()) return std::nullopt;
  return Approach{pass.distance_m, pass.t_s, std::move(to), 0};
}

Closest closest_of(const Agent& agent, const NearestPasses& nearest, const EndedRun& run) {
  const auto of_vehicle = [&](const NearestPass& pass) {
    return pass.is_any() ? run.agents[static_cast<std::size_t>(pass.whom)].name : std::string();
  };
  Closest closest;
  closest.vehicle = named(nearest.vehicle, of_vehicle(nearest.vehicle));
  closest.tether = named(nearest.line, of_vehicle(nearest.line));
  if (nearest.structure.is_any())
    closest.structure = named(
        nearest.structure, run.structures[static_cast<std::size_t>(nearest.structure.whom)].name);
  if (nearest.vessel.is_any()) {
    const auto mmsi = static_cast<std::uint32_t>(nearest.vessel.whom);
    closest.vessel = named(nearest.vessel, name_of_vessel(*agent.vessels, mmsi));
    closest.vessel->mmsi = mmsi;
  }
  return closest;
}

bool reserve_is_broken(const Agent& agent, const ConductState& own) {
  // On a deck it may have been given another battery.
  const bool is_on_its_deck = own.is_aboard && goes_aboard(agent);
  return agent.conduct->full_j > 0 && own.has_ended && !is_on_its_deck &&
         own.at_end.charge < agent.conduct->plan.reserve.share;
}

/// The first of what befell it before it ended; of a halt, whenever that was.
std::string befell_before(const VehicleAccount& account, double ended_s) {
  for (const Fate what : {Fate::battery_empty, Fate::battery_cut_off})
    if (const auto at_s = time_of(account.fate, what); at_s && *at_s < ended_s)
      return words_of(what);
  if (account.halt != Halt::none) return words_of(account.fate.back().what);
  if (const auto at_s = time_of(account.fate, Fate::tether_parted); at_s && *at_s < ended_s)
    return words_of(Fate::tether_parted);
  return "";
}

std::string stopped_by(const Agent& agent, const AgentState& state, const VehicleAccount& account) {
  const ConductState& own = state.conduct;
  const double ended_s = own.has_ended ? own.events.back().t_s : std::numeric_limits<double>::max();
  // One that is home and one that is not, for the same reason, ended otherwise.
  const auto told = [&](const std::string& why) {
    return is_still_out(agent, state) ? words_of(Fate::not_recovered) + (": " + why) : why;
  };
  if (std::string befell = befell_before(account, ended_s); !befell.empty()) return told(befell);
  if (own.has_turned || own.doing == Doing::hold)
    return told(words_of(agent, own.cause, own.cause_detail));
  if (!own.has_ended || !state.mission.is_done) return told("out of time");
  if (account.broke_reserve) return "reserve broken";
  // All it did, and the work is not done for all that. What was not seen is told apart.
  if (account.cleaning && !account.cleaning->is_done())
    return formatted("less than {:g} % of the surface is clean", 100 * account.cleaning->done_at);
  return "";
}

void add_conduct(const Agent& agent, const AgentState& state, VehicleAccount& account) {
  const ConductState& own = state.conduct;
  if (own.has_ended) account.on_mission = own.at_end;
  if (own.has_ended && !own.events.empty()) account.ended_s = own.events.back().t_s;
  account.mission = mission_events_of(agent, own);
  account.held_s = own.held_s;
  account.worst_share = own.most_share;
  account.least_charge = own.least_charge;
  account.broke_reserve = reserve_is_broken(agent, own);
  if (own.search.is_found) account.found_s = own.search.found_s;
  if (agent.conduct->cleaning)
    account.cleaning = cleaning_outcome(*agent.conduct->cleaning, own.cleaning);
  account.stopped_by = stopped_by(agent, state, account);
}

bool had_cause(const VehicleAccount& account, Cause cause) {
  return std::any_of(account.mission.begin(), account.mission.end(),
                     [&](const MissionEvent& event) { return event.cause == cause; });
}

}  // namespace

double ClearanceAccount::alarms() const noexcept {
  return std::accumulate(alarms_from.begin(), alarms_from.end(), 0.0);
}

std::optional<bool> VehicleAccount::is_seen() const noexcept {
  return inspection ? inspection->is_seen() : std::nullopt;
}

double VehicleAccount::work_share() const noexcept {
  return tasks > 0 ? static_cast<double>(std::min(tasks_done, tasks)) / static_cast<double>(tasks)
                   : 1;
}

std::string VehicleAccount::fate_text(UtcTime start) const {
  return twin::fate_text(fate, start, closest.structure ? closest.structure->to : "");
}

RiskCauses VehicleAccount::risks() const {
  const auto befell = [&](Fate what) {
    const auto at_s = time_of(fate, what);
    return at_s && *at_s < ended_s;
  };
  const bool is_left_out = time_of(fate, Fate::not_recovered).has_value();
  RiskCauses set;
  if (worst_share > 1 || had_cause(*this, Cause::limit)) set.add(RiskCause::limit);
  if (had_cause(*this, Cause::reserve) || broke_reserve || befell(Fate::battery_empty) ||
      befell(Fate::battery_cut_off))
    set.add(RiskCause::energy);
  if (had_cause(*this, Cause::tether) || befell(Fate::tether_parted)) set.add(RiskCause::tether);
  if (halt == Halt::no_headway || halt == Halt::capsized) set.add(RiskCause::station);
  if (halt == Halt::struck || halt == Halt::aground || (clearance && clearance->alarms() > 0))
    set.add(RiskCause::collision);
  // Where nobody knows what became of it, nobody brought it back either.
  if (halt == Halt::outside_area || halt == Halt::outside_time || halt == Halt::no_data ||
      is_left_out)
    set.add(RiskCause::recovery);
  if (!is_done && set.none()) set.add(RiskCause::work);
  if (is_seen() == false) set.add(RiskCause::unseen);
  return set;
}

VehicleAccount account_of(const EndedRun& run, std::size_t vehicle) {
  const Agent& agent = run.agents[vehicle];
  const AgentState& state = run.states[vehicle];
  VehicleAccount account;
  account.name = agent.name;
  account.model = agent.vehicle->id;
  account.makeup = makeup_of(agent);
  account.fate = fate_of(agent, state, run.ran_s);
  account.halt = state.halt;
  account.halted_at_s = state.halted_at_s;
  account.ended_s = state.halt != Halt::none ? state.halted_at_s : run.ran_s;
  account.tasks = agent.mission.tasks.size();
  account.tasks_done = state.mission.task;
  account.waypoints = state.mission.waypoints_taken + state.helm.way.waypoints_taken;
  account.in_all = {state.vehicle.drawn_j, state.vehicle.fuel_kg, state.vehicle.battery.charge};
  account.on_mission = account.in_all;
  account.thrust_used = state.thrust.most;
  if (agent.tether)
    account.line_used = state.milestones.most_line_n / agent.tether->breaking_load_n;
  account.largest_roll_rad = state.milestones.largest_roll_rad();
  account.largest_pitch_rad = state.milestones.largest_pitch_rad();
  account.closest = closest_of(agent, state.nearest, run);
  if (agent.clearance)
    account.clearance = ClearanceAccount{state.clearance.alarms_from, state.clearance.changed_s};
  account.manoeuvres = manoeuvres_of(agent.mission, state.mission);
  if (agent.inspection)
    account.inspection = inspection_outcome(*agent.inspection, state.inspection);
  if (agent.conduct)
    add_conduct(agent, state, account);
  else if (state.halt != Halt::none)
    account.stopped_by = befell_before(account, state.halted_at_s);
  account.is_done = account.stopped_by.empty();
  return account;
}

void add_rows(const VehicleRows& rows, VehicleAccount& account) {
  account.track = track_of(rows);
  account.at_work = track_of(rows, account.ended_s);
  const double last_s = rows.t_s.empty() ? 0 : rows.t_s.back();
  add_rows(rows, account.halt != Halt::none ? account.halted_at_s : last_s, account.manoeuvres);
}

}  // namespace slackwater::twin
