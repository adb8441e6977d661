#include "twin/run/run.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "fields/base/check.h"
#include "twin/agent/coarse_step.h"
#include "twin/agent/conduct.h"
#include "twin/agent/helm.h"
#include "twin/agent/line_on_deck.h"
#include "twin/step/soundness.h"
#include "twin/step/vehicle_step.h"

namespace slackwater::twin {
namespace {

/// Whether two vehicles make the same step, so that they may lie in one block.
bool steps_alike(const Agent& a, const Agent& b) {
  return a.vehicle == b.vehicle && a.steps_per_barrier == b.steps_per_barrier &&
         a.plan.dt_s == b.plan.dt_s && a.plan.held_voltage_v == b.plan.held_voltage_v &&
         a.coarse.has_value() == b.coarse.has_value();
}

Seen seen_of(const AgentState& state) {
  const BodyState<double>& body = state.vehicle.body;
  return {body.position_m, rotation_of(body.attitude).to_ned(body.nu.linear), state.halt,
          state.halted_at_s};
}

}  // namespace

Run::Run(std::vector<Agent> agents, std::vector<AgentState> states, const RunSettings& settings)
    : began_with_(agents.size()),
      most_vehicles_(agents.size() + settings.most_newcomers),
      most_in_block_(settings.is_batch ? block_lanes : 1),
      there_(agents.size()),
      expected_(agents.size()),
      agents_(std::move(agents)),
      states_(std::move(states)),
      seen_(states_.size()),
      carried_(states_.size()),
      companies_(states_.size()),
      picture_(agents_),
      approaches_(agents_),
      block_(settings.path ? step_block_on(*settings.path) : step_block()),
      pull_(settings.path ? pull_block_on(*settings.path) : pull_block()),
      hosted_(states_.size()),
      scheduler_(settings.seed, settings.step_s, settings.threads) {
  expects(!agents_.empty() && agents_.size() == states_.size(), "a state for each vehicle");
  for (const Agent& agent : agents_) {
    const double steps_s = agent.plan.dt_s * static_cast<double>(agent.steps_per_barrier);
    expects(std::abs(steps_s - settings.step_s) < 1e-9 * settings.step_s,
            "the steps of a vehicle fill that of the barrier");
  }
  agents_.reserve(most_vehicles_);
  states_.reserve(most_vehicles_);
  seen_.reserve(most_vehicles_);
  carried_.reserve(most_vehicles_);
  companies_.reserve(most_vehicles_);
  hosted_.reserve(most_vehicles_);
  for (std::size_t i = 0; i < agents_.size(); ++i)
    if (agents_[i].carrier) carried_[*agents_[i].carrier].push_back(i);
  for (std::size_t i = 0; i < agents_.size(); ++i) put_in_a_group(i);
  scheduler_.before_step([this](const StepTime& time) {
    for (const Scheduler::Client& driver : drivers_) driver(time);
    take_commands(time);
    mind_helms(time);
    tick_behaviours(time);
  });
  publish();
  approaches_.begin(states_, 0);
  approaches_.look(agents_, states_, 0);
  scheduler_.at_barrier([this](const StepTime& time) {
    note_hosted(time);
    publish();
    approaches_.look(agents_, states_, time_s());
  });
}

/// Into the last one with room, or one of its own.
void Run::put_in_a_group(std::size_t agent) {
  const auto has_room = [&](const Group& group) {
    return group.agents.empty() || (group.agents.size() < most_in_block_ &&
                                    steps_alike(agents_[group.agents.front()], agents_[agent]));
  };
  const auto found = std::find_if(groups_.rbegin(), groups_.rend(), has_room);
  if (found != groups_.rend()) return found->agents.push_back(agent);
  Group& group = groups_.emplace_back();
  group.agents.push_back(agent);
  scheduler_.add_client([this, &group](const StepTime& time) { step_any(group, time); });
}

/// Of the vehicles that are there now, none of which has moved.
void Run::look_round(double t_s) {
  picture_ = CommonPicture(agents_);
  picture_.publish(agents_, states_, t_s);
  approaches_ = ApproachWatch(agents_);
  approaches_.begin(states_, t_s);
}

void Run::join(const ReadyNewcomer& newcomer) {
  expects(agents_.size() < most_vehicles_, "room for a vehicle that joins");
  agents_.push_back(newcomer.agent);
  states_.push_back(newcomer.state);
  seen_.push_back(seen_of(newcomer.state));
  carried_.emplace_back();
  companies_.emplace_back();
  hosted_.emplace_back();
  put_in_a_group(agents_.size() - 1);
  for (Group& group : groups_) group.is_loaded = false;
  there_ = agents_.size();
}

void Run::publish() {
  move_tops(agents_, states_, time_s());
  for (std::size_t i = 0; i < states_.size(); ++i) seen_[i] = seen_of(states_[i]);
  picture_.publish(agents_, states_, time_s());
}

void Run::step_one(std::size_t index, const StepTime& time) {
  const Agent& agent = agents_[index];
  AgentState& state = states_[index];
  if (state.is_hosted) return step_hosted(index, time);
  StepInput input;
  for (std::size_t k = 0; k < agent.steps_per_barrier; ++k) {
    if (!moves(state)) return;
    const double t_s = time.start_s + static_cast<double>(k) * agent.plan.dt_s;
    make_coarse_step(agents_, states_, {&index, 1}, t_s, nullptr);
    if (!prepare(agent, t_s, picture_.seen_by(agent, index), state, input)) return;
    VehicleState<double> next = state.vehicle;
    twin::step(*agent.vehicle, agent.plan, next, input.command, input.around);
    if (is_sound(next.body, next.battery.charge) && doubt_of(next) == 0) {
      state.vehicle = next;
      note_power(state.milestones, next.battery.off, next.battery.charge, t_s + agent.plan.dt_s);
    } else {
      halt(state, Halt::diverged, t_s + agent.plan.dt_s);
    }
  }
}

/// All of its steps but the motion, which comes at the end of them.
void Run::step_hosted(std::size_t index, const StepTime& time) {
  const Agent& agent = agents_[index];
  AgentState& state = states_[index];
  Hosted& hosted = hosted_[index];
  StepInput input;
  for (std::size_t k = 0; k < agent.steps_per_barrier; ++k) {
    if (!moves(state)) return;
    const double t_s = time.start_s + static_cast<double>(k) * agent.plan.dt_s;
    make_coarse_step(agents_, states_, {&index, 1}, t_s, nullptr);
    if (!prepare(agent, t_s, picture_.seen_by(agent, index), state, input)) return;
  }
  if (hosted.physics) hosted.answered = hosted.physics({time, agent, state, input});
  const std::optional<VehicleState<double>>& next =
      hosted.answered ? hosted.answered : hosted.recorded;
  if (!next) return;
  if (is_sound(next->body, next->battery.charge) && doubt_of(*next) == 0) {
    state.vehicle = *next;
    note_power(state.milestones, next->battery.off, next->battery.charge, time.end_s());
  } else {
    halt(state, Halt::diverged, time.end_s());
  }
}

void Run::load(Group& group) {
  for (std::size_t lane = 0; lane < block_lanes; ++lane) {
    // Lanes without a vehicle go along with numbers that do no harm.
    const bool is_free = lane >= group.agents.size();
    put(group.block, lane, states_[group.agents[is_free ? 0 : lane]].vehicle);
    put(group.command, lane, VehicleCommand<double>{});
    put(group.around, lane, Surroundings<double>{});
  }
  group.is_loaded = true;
  group.is_ahead = false;
}

void Run::unload(Group& group) {
  if (!group.is_ahead) return;
  for (std::size_t lane = 0; lane < group.agents.size(); ++lane) {
    AgentState& state = states_[group.agents[lane]];
    if (is_stepped(state)) state.vehicle = taken(group.block, lane);
  }
  group.is_ahead = false;
}

void Run::step_any(Group& group, const StepTime& time) {
  if (group.agents.empty()) return;
  if (group.agents.size() > 1)
    step_group(group, time);
  else
    step_one(group.agents.front(), time);
}

void Run::step_group(Group& group, const StepTime& time) {
  if (!group.is_loaded) load(group);
  const Agent& first = agents_[group.agents.front()];
  const bool floats = first.vehicle->body.hull.strips > 0;
  for (const std::size_t index : group.agents)
    if (states_[index].is_hosted) step_hosted(index, time);
  StepInput input;
  for (std::size_t k = 0; k < first.steps_per_barrier; ++k) {
    const double t_s = time.start_s + static_cast<double>(k) * first.plan.dt_s;
    make_coarse_step(agents_, states_, group.agents, t_s, pull_);
    bool any = false;
    for (std::size_t lane = 0; lane < group.agents.size(); ++lane) {
      AgentState& state = states_[group.agents[lane]];
      if (!is_stepped(state)) continue;
      const std::size_t index = group.agents[lane];
      const Agent& agent = agents_[index];
      if (!prepare(agent, t_s, picture_.seen_by(agent, index), state, input)) {
        halt_lane(group, lane, group.block);
        continue;
      }
      put(group.command, lane, input.command);
      put(group.around.water, lane, input.around.water);
      put(group.around.wind_m_s, lane, input.around.wind_m_s);
      put(group.around.pull_n, lane, input.around.pull_n);
      group.around.height_above_m.lane[lane] = input.around.height_above_m;
      if (floats) {
        put(group.around.at_strips, lane, input.around.at_strips);
        put(group.around.turn_n_m, lane, input.around.turn_n_m);
      }
      any = true;
    }
    if (!any) return;
    group.before = group.block;
    block_(*first.vehicle, first.plan, group.block, group.command, group.around);
    group.is_ahead = true;
    const Eight doubt = doubt_of(group.block);
    for (std::size_t lane = 0; lane < group.agents.size(); ++lane) {
      AgentState& state = states_[group.agents[lane]];
      if (!is_stepped(state)) continue;
      // What the next look at the surroundings needs.
      const BodyState<double> body = taken(group.block.body, lane);
      if (is_sound(body, group.block.battery.charge.lane[lane]) && doubt.lane[lane] == 0) {
        state.vehicle.body = body;
        state.vehicle.bus_voltage_v = group.block.bus_voltage_v.lane[lane];
        const BatteryState<Eight>& battery = group.block.battery;
        note_power(state.milestones, battery.off.lane[lane], battery.charge.lane[lane],
                   t_s + first.plan.dt_s);
      } else {
        halt(state, Halt::diverged, t_s + first.plan.dt_s);
        halt_lane(group, lane, group.before);
      }
    }
  }
}

/// The last sound state of a vehicle that goes no further; its lane is given harmless numbers.
void Run::halt_lane(Group& group, std::size_t lane, const VehicleState<Eight>& last) {
  AgentState& state = states_[group.agents[lane]];
  state.vehicle = taken(last, lane);
  put(group.block, lane, state.vehicle);
}

std::span<const AgentState> Run::states() {
  for (Group& group : groups_) unload(group);
  return states_;
}

void Run::enqueue(Command command) {
  if (const auto* spawn = std::get_if<Spawn>(&command.what)) {
    expects(spawn->ready != nullptr, "a vehicle that joins is ready");
    expects(expected_++ < most_vehicles_, "room for a vehicle that joins");
  } else {
    expects(command.agent < expected_, "a command is for a vehicle of the run");
    // Of one that is on its way, when it is taken.
    expects(command.agent >= there_ || unsoundness_of(command, agents_[command.agent]).empty(),
            "the numbers of a command are those that a vehicle can follow");
  }
  commands_.put(std::move(command));
}

void Run::host_physics(std::size_t agent, HostedPhysics physics, std::string source) {
  expects(agent < agents_.size(), "physics are hosted for a vehicle of the run");
  hosted_[agent].physics = std::move(physics);
  hosted_[agent].source = std::move(source);
}

void Run::take_commands(const StepTime& time) {
  std::vector<Command> due = commands_.take(time.step);
  if (due.empty()) return;
  for (Group& group : groups_) unload(group);
  for (Command& command : due) take_command(command, time);
}

void Run::take_command(Command& command, const StepTime& time) {
  if (const auto* spawn = std::get_if<Spawn>(&command.what)) {
    command.agent = agents_.size();
    join(*spawn->ready);
    look_round(time.start_s);
  }
  if (const auto* weather = std::get_if<SetWeather>(&command.what))
    set_weather(weather->asked, time.start_s);
  const std::size_t index = command.agent;
  expects(index < agents_.size(), "a command is for a vehicle of the run");
  expects(index < began_with_ || unsoundness_of(command, agents_[index]).empty(),
          "the numbers of a command are those that a vehicle can follow");
  AgentState& state = states_[index];
  const auto* put = std::get_if<PutVehicle>(&command.what);
  if (put != nullptr && state.is_hosted) {
    hosted_[index].recorded = *put->vehicle;
  } else {
    apply(command, time.start_s, agents_[index], state);
    if (put != nullptr || std::holds_alternative<HostPhysics>(command.what)) {
      approaches_.put(index, state);
      for (Group& group : groups_) group.is_loaded = false;
    }
  }
  command.step = time.step;
  taken_.push_back(std::move(command));
}

/// Of each environment once: vehicles share theirs.
void Run::set_weather(const WeatherAsked& asked, double t_s) {
  std::set<WeatherInHand*> done;
  for (const Agent& agent : agents_) {
    const Environment& environment = agent.water->environment();
    expects(environment.weather != nullptr, "the weather of a run may be led");
    if (done.insert(environment.weather.get()).second)
      environment.weather->set(asked, environment, t_s);
  }
}

void Run::mind_helms(const StepTime& time) {
  for (std::size_t i = 0; i < agents_.size(); ++i) mind_helm(agents_[i], time.start_s, states_[i]);
}

/// What the physics of others made of the step, for the record; by the vehicles' order.
void Run::note_hosted(const StepTime& time) {
  for (std::size_t i = 0; i < hosted_.size(); ++i) {
    Hosted& hosted = hosted_[i];
    hosted.recorded.reset();
    if (!hosted.answered) continue;
    taken_.push_back(
        {time.step, i, PutVehicle{*hosted.answered}, hosted.source, time.step, time.end_s()});
    hosted.answered.reset();
  }
}

/// Before anybody decides anything: what a watch sees in a tick is heard at the next, whoever of
/// the two stands first in the run.
void Run::hear_watches(const StepTime& time) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_[i];
    if (!agent.zone || time.step % agent.conduct->steps_per_tick != 0) continue;
    ZoneReport report;
    for (const std::size_t watcher : agent.zone->watchers) {
      const AgentState& watch = states_[watcher];
      add_to(report, watch.conduct.mammals, watch.halt == Halt::none && !watch.conduct.has_ended);
    }
    hear(agent.zone->rule, report, time.start_s, states_[i].conduct.noisy);
  }
}

/// Who carries, or is carried, knows of the others what was before any of them is ticked.
void Run::meet_companies(const StepTime& time) {
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_[i];
    if (!agent.conduct || time.step % agent.conduct->steps_per_tick != 0) continue;
    if (agent.carrier || !carried_[i].empty())
      companies_[i] = company_of(agents_, states_, i, carried_[i]);
  }
}

void Run::tick_behaviours(const StepTime& time) {
  hear_watches(time);
  meet_companies(time);
  for (std::size_t i = 0; i < agents_.size(); ++i) {
    const Agent& agent = agents_[i];
    if (!agent.conduct || time.step % agent.conduct->steps_per_tick != 0) continue;
    if (states_[i].is_retired) continue;
    (void)states();
    if (!tick_conduct(agent, time.start_s, states_[i], companies_[i], changes_)) continue;
    approaches_.put(i, states_[i]);
    for (Group& group : groups_) group.is_loaded = false;
  }
}

bool Run::must_come_home(std::size_t agent) const noexcept {
  return twin::must_come_home(agents_[agent], states_[agent]);
}

bool Run::has_ended(std::size_t index) const noexcept {
  const AgentState& state = states_[index];
  return !agents_[index].conduct || state.halt != Halt::none || state.conduct.has_ended;
}

bool Run::all_ended() const noexcept {
  for (std::size_t i = 0; i < states_.size(); ++i)
    if (!has_ended(i)) return false;
  return true;
}

void Run::retire(std::size_t index) {
  (void)states();
  states_[index].is_retired = true;
}

Run::Checkpoint Run::checkpoint() {
  (void)states();
  return {steps_made(), states_, taken_, commands_.waiting()};
}

double Run::time_s() const noexcept {
  return static_cast<double>(scheduler_.steps_made()) * scheduler_.step_s();
}

bool Run::all_halted() const noexcept {
  return std::all_of(states_.begin(), states_.end(),
                     [](const AgentState& s) { return s.halt != Halt::none; });
}

void Run::run_until(double end_s, RunControl& control) {
  const auto steps = static_cast<std::uint64_t>(std::llround(end_s / scheduler_.step_s()));
  (void)scheduler_.run(steps, control);
}

/// In the place of those of this run.
void Run::bring_back_newcomers(std::span<const Command> taken) {
  if (agents_.size() > began_with_) {
    const auto keep = [&](auto& list) {
      list.erase(list.begin() + static_cast<std::ptrdiff_t>(began_with_), list.end());
    };
    keep(agents_);
    keep(states_);
    keep(seen_);
    keep(carried_);
    keep(companies_);
    keep(hosted_);
    for (Group& group : groups_)
      std::erase_if(group.agents, [&](std::size_t agent) { return agent >= began_with_; });
    there_ = agents_.size();
  }
  for (const Command& command : taken)
    if (const auto* spawn = std::get_if<Spawn>(&command.what)) {
      expects(spawn->ready != nullptr, "a vehicle that joins is ready");
      join(*spawn->ready);
    }
}

void Run::bring_back_weather(std::span<const Command> taken) {
  for (const Agent& agent : agents_)
    if (const auto& weather = agent.water->environment().weather) weather->forget();
  for (const Command& command : taken)
    if (const auto* weather = std::get_if<SetWeather>(&command.what))
      set_weather(weather->asked, static_cast<double>(command.step) * step_s());
}

void Run::restore(const Checkpoint& checkpoint) {
  const auto newcomers = [](std::span<const Command> commands) {
    return static_cast<std::size_t>(std::count_if(
        commands.begin(), commands.end(),
        [](const Command& command) { return std::holds_alternative<Spawn>(command.what); }));
  };
  const std::size_t there = began_with_ + newcomers(checkpoint.taken);
  const std::size_t expected = there + newcomers(checkpoint.waiting);
  expects(checkpoint.states.size() == there && expected <= most_vehicles_,
          "a checkpoint of this run's vehicles");
  for (const Command& command : checkpoint.waiting)
    expects(command.agent < expected, "a command is for a vehicle of the run");
  if (there > began_with_ || agents_.size() > began_with_) {
    bring_back_newcomers(checkpoint.taken);
    look_round(time_s());
  }
  expected_ = expected;
  bring_back_weather(checkpoint.taken);
  states_ = checkpoint.states;
  taken_ = checkpoint.taken;
  commands_.restore(checkpoint.waiting);
  for (Group& group : groups_) {
    group.is_loaded = false;
    group.is_ahead = false;
  }
  scheduler_.resume_at(checkpoint.steps_made);
  approaches_.begin(states_, time_s());
  publish();
}

}  // namespace slackwater::twin
