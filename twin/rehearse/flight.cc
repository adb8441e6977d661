#include "twin/rehearse/flight.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/agent/conduct.h"

namespace slackwater::twin {
namespace {

/// The vehicles of several cases in one run, those of a case one after the other.
struct Fleet {
  std::vector<Agent> agents;
  std::vector<AgentState> states;
  std::size_t per_case = 0;
};

Fleet assembled(const Scenario& mission, Surround surround, std::span<const FlightCase> cases) {
  Fleet fleet;
  surround = shared_by_flights(mission, std::move(surround));
  for (const FlightCase& flown : cases) {
    Scenario scenario = mission;
    scenario.start = flown.start;
    // Of made-up water futures differ in their seed alone.
    if (!std::holds_alternative<MadeUpWater>(mission.water)) scenario.member = flown.member;
    scenario.seed = seed_of(mission.seed, flown);
    ReadyRun ready = set_up(scenario, surround);
    const std::size_t first = fleet.agents.size();
    fleet.per_case = ready.agents.size();
    for (std::size_t i = 0; i < ready.agents.size(); ++i) {
      Agent& agent = ready.agents[i];
      if (agent.carrier) *agent.carrier += first;
      if (agent.zone)
        for (std::size_t& watcher : agent.zone->watchers) watcher += first;
      fleet.agents.push_back(std::move(agent));
      fleet.states.push_back(std::move(ready.states[i]));
    }
  }
  return fleet;
}

FlightSample sample_of(const Agent& agent, const AgentState& state, double t_s) {
  FlightSample sample;
  const Triple<double>& at_m = state.vehicle.body.position_m;
  sample.north_m = static_cast<float>(at_m.x);
  sample.east_m = static_cast<float>(at_m.y);
  sample.down_m = static_cast<float>(at_m.z);
  sample.charge = static_cast<float>(state.vehicle.battery.charge);
  const auto value = [&](LimitVariable variable, std::optional<double> down_m) {
    Limit limit;
    limit.variable = variable;
    limit.down_m = down_m;
    return static_cast<float>(value_of(limit, agent, t_s, state));
  };
  if (!agent.conduct) return sample;
  const ReadyConduct& conduct = *agent.conduct;
  const ConductState& own = state.conduct;
  if (conduct.full_j > 0)
    sample.needed =
        static_cast<float>(conduct.plan.reserve.share +
                           conduct.plan.reserve.margin * own.energy_home_j / conduct.full_j);
  sample.current_m_s = value(LimitVariable::current_speed, std::nullopt);
  sample.wind_m_s = value(LimitVariable::wind_speed, std::min(at_m.z, -10.0));
  sample.wave_height_m = value(LimitVariable::significant_wave_height, std::nullopt);
  sample.phase = static_cast<std::uint8_t>(own.phase);
  sample.doing = static_cast<std::uint8_t>(own.doing);
  return sample;
}

/// A flight that is over is not flown on while others last.
void retire_ended(Run& run, std::size_t per_case) {
  const std::size_t count = run.agents().size();
  for (std::size_t first = 0; first < count; first += per_case) {
    const auto ended = [&](std::size_t i) { return run.has_ended(i); };
    std::size_t last = first;
    while (last < first + per_case && ended(last)) ++last;
    if (last < first + per_case) continue;
    for (std::size_t i = first; i < last; ++i) run.retire(i);
  }
}

bool counts(const Agent& agent, const FlightSettings& settings) {
  if (settings.workers.empty()) return agent.conduct != nullptr;
  return std::find(settings.workers.begin(), settings.workers.end(), agent.name) !=
         settings.workers.end();
}

/// A vehicle whose work does not count still must not be lost: nor be without power, or on its way
/// home, when its time is over.
bool is_lost(const Agent& agent, const AgentState& state) {
  if (is_still_out(agent, state) &&
      (state.conduct.has_turned || !std::isnan(state.milestones.power_lost_s)))
    return true;
  switch (state.halt) {
    case Halt::struck:
    case Halt::capsized:
    case Halt::aground:
    case Halt::diverged:
      return true;
    default:
      return false;
  }
}

/// What the inspections of a vehicle whose work counts saw of what is asked.
void note_seen(const VehicleAccount& vehicle, Flight& flight) {
  const std::optional<bool> is_seen = vehicle.is_seen();
  if (!is_seen) return;
  if (!*is_seen && flight.unseen_by.empty())
    flight.unseen_by = vehicle.inspection->left + " (" + vehicle.name + ")";
  flight.is_seen = flight.is_seen.value_or(true) && *is_seen;
}

/// A search is done when somebody was found, by whichever vehicle.
void note_search(Flight& flight) {
  bool is_search = false;
  for (const VehicleAccount& vehicle : flight.vehicles) {
    is_search |= vehicle.makeup.searches;
    if (vehicle.found_s) flight.found_s = std::min(flight.found_s.value_or(1e99), *vehicle.found_s);
  }
  if (!is_search || flight.found_s) return;
  if (flight.is_done) flight.stopped_by = "not found";
  flight.is_done = false;
}

bool any_sighting(std::span<const MammalDutyState* const> watches) {
  return std::any_of(watches.begin(), watches.end(),
                     [](const MammalDutyState* watch) { return !watch->sightings_s.empty(); });
}

/// The noise of vehicles whose work it is; whether that was done is theirs to say.
/// @param first, end  of the vehicles of a flight in the run
void note_noisy_work(std::span<const Agent> agents, std::span<const AgentState> states,
                     std::size_t first, std::size_t end, double ran_s, Flight& flight) {
  for (std::size_t i = first; i < end; ++i) {
    if (!agents[i].zone) continue;
    std::vector<const MammalDutyState*> watches;
    for (const std::size_t watcher : agents[i].zone->watchers)
      watches.push_back(&states[watcher].conduct.mammals);
    const double end_s = states[i].halt == Halt::none ? ran_s : states[i].halted_at_s;
    const NoiseRecord own =
        noise_made(states[i].conduct.noisy, watches, end_s, agents[i].conduct->plan.tick_s);
    if (!flight.noise) flight.noise.emplace();
    flight.noise->noise_s += own.noise_s;
    flight.noise->stops += own.stops;
    flight.noise->exposed_s += own.exposed_s;
    flight.noise->by += (flight.noise->by.empty() ? "" : ", ") + agents[i].name;
  }
}

/// Noisy work on a schedule is done when the watches of all vehicles together let there be as much
/// as wanted.
void note_noise(std::span<const Agent> agents, std::span<const AgentState> states, double ran_s,
                Flight& flight) {
  std::vector<const MammalDutyState*> watches;
  const ReadyConduct* first = nullptr;
  for (std::size_t i = 0; i < agents.size(); ++i) {
    if (!agents[i].conduct || !agents[i].conduct->plan.mammals ||
        !agents[i].conduct->plan.mammals->noise_by.empty())
      continue;
    if (first == nullptr) first = agents[i].conduct.get();
    watches.push_back(&states[i].conduct.mammals);
  }
  if (first == nullptr) return;
  const NoiseRule& rule = first->plan.mammals->noise;
  flight.noise = noise_under(rule, watches, ran_s, first->plan.tick_s);
  if (flight.noise->is_done(rule)) return;
  if (flight.is_done)
    flight.stopped_by = flight.noise->stops > 0 || any_sighting(watches)
                            ? "marine mammals within the radius"
                            : "the watch for marine mammals was too short";
  flight.is_done = false;
}

}  // namespace

Surround shared_by_flights(const Scenario& mission, Surround surround) {
  // Vehicles of one kind lie in one block.
  if (surround.vehicles.empty()) surround.vehicles = read_vehicles(mission, surround.data_folder);
  if (surround.inspections.empty()) {
    Scenario flown = mission;
    flown.rays_per_look = std::min(flown.rays_per_look, rays_per_look_of_many);
    surround.inspections = read_inspections(flown, surround.data_folder);
  }
  return surround;
}

std::uint64_t seed_of(std::uint64_t mission_seed, const FlightCase& flown) noexcept {
  const auto start = static_cast<std::uint64_t>(flown.start.time_since_epoch().count());
  return split_mix_64(split_mix_64(mission_seed ^ split_mix_64(start)) + flown.member) &
         0x7FFFFFFFU;
}

std::vector<Flight> fly(const Scenario& mission, const Surround& surround,
                        std::span<const FlightCase> cases, const FlightSettings& settings) {
  Fleet fleet = assembled(mission, surround, cases);
  std::vector<Flight> flights(cases.size());
  RunSettings run_settings;
  run_settings.seed = mission.seed;
  run_settings.step_s = mission.step_s;
  const std::size_t per_case = fleet.per_case;
  Run run(std::move(fleet.agents), std::move(fleet.states), run_settings);
  const auto steps = static_cast<std::uint64_t>(std::llround(mission.duration_s / mission.step_s));
  const auto sample_steps = std::max<std::uint64_t>(
      1, static_cast<std::uint64_t>(std::llround(settings.sample_every_s / mission.step_s)));
  for (Flight& flight : flights) flight.samples.resize(per_case);
  const auto sample = [&] {
    const auto states = run.states();
    for (std::size_t i = 0; i < states.size(); ++i)
      flights[i / per_case].samples[i % per_case].push_back(
          sample_of(run.agents()[i], states[i], run.time_s()));
  };
  while (run.steps_made() < steps && !run.all_ended()) {
    if (run.steps_made() % sample_steps == 0) {
      sample();
      retire_ended(run, per_case);
    }
    run.step();
  }
  sample();
  const auto states = run.states();
  const EndedRun ended{run.agents(), states, mission.structures, run.time_s()};
  for (std::size_t c = 0; c < cases.size(); ++c) {
    Flight& flight = flights[c];
    flight.flown = cases[c];
    flight.is_done = true;
    double over_s = 0;  // for all of its vehicles, of work or not
    for (std::size_t i = c * per_case; i < (c + 1) * per_case; ++i) {
      const Agent& agent = run.agents()[i];
      flight.vehicles.push_back(account_of(ended, i));
      const VehicleAccount& outcome = flight.vehicles.back();
      over_s = std::max(over_s, outcome.ended_s);
      const bool has_work = counts(agent, settings);
      if (!has_work && !is_lost(agent, states[i])) continue;
      flight.ended_s = std::max(flight.ended_s, outcome.ended_s);
      if (has_work) note_seen(outcome, flight);
      if (has_work && outcome.is_done) continue;
      if (flight.is_done) flight.stopped_by = outcome.stopped_by + " (" + outcome.name + ")";
      flight.is_done = false;
    }
    note_search(flight);
    note_noisy_work(run.agents(), states, c * per_case, (c + 1) * per_case, over_s, flight);
    note_noise(run.agents().subspan(c * per_case, per_case), states.subspan(c * per_case, per_case),
               over_s, flight);
  }
  return flights;
}

}  // namespace slackwater::twin
