#pragma once
#include <atomic>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/agent/company.h"
#include "twin/run/approach_watch.h"
#include "twin/run/command_queue.h"
#include "twin/run/scheduler.h"
#include "twin/step/step_dispatch.h"

namespace slackwater::twin {

/// How a run is stepped. None of it changes a bit of what comes out.
struct RunSettings {
  std::uint64_t seed = 0;
  double step_s = 0.1;  ///< of the barrier
  std::size_t threads = 1;
  bool is_batch = true;            ///< eight vehicles of one kind at a time; else one by one
  std::optional<KernelPath> path;  ///< absent: the widest of this machine
  /// Vehicles for which room is kept: so many may join while it goes on (`Spawn`). Those that are
  /// there stay where they are in memory.
  std::size_t most_newcomers = 0;
};

/// What others see of a vehicle.
struct Seen {
  Triple<double> position_m;    ///< NED
  Triple<double> velocity_m_s;  ///< over ground, NED
  Halt halt = Halt::none;
  double halted_at_s = 0;
};

/// A step of a vehicle whose physics are made elsewhere.
struct HostedStep {
  StepTime time;
  const Agent& agent;
  const AgentState& state;  ///< at its start
  const StepInput& input;   ///< what its actuators are to do, and what is around it
};

/// Vehicles and the clock that steps them. Vehicles may share one environment, or each have that of
/// its own member.
class Run {
 public:
  Run(std::vector<Agent> agents, std::vector<AgentState> states, const RunSettings& settings);

  /// One step of the barrier: each vehicle that goes on makes its own steps within it. No
  /// allocation, but where a mission begins a route.
  void step() { scheduler_.step(); }
  /// Steps until `end_s` or until the control says stop.
  void run_until(double end_s, RunControl& control);

  /// From any thread: takes effect between two steps, before the step it asks for or the next one.
  /// Where several do, by the step they ask for and then as they came.
  /// @throws ContractViolation for a vehicle that is not there nor on its way, waypoints that are
  ///         not finite, a newcomer that is not ready or for which there is no room
  void enqueue(Command command);
  /// Vehicles that it can have in all. For any thread.
  [[nodiscard]] std::size_t most_vehicles() const noexcept { return most_vehicles_; }
  /// Between steps: all that took effect, in order, each with the step before which it did.
  /// Enqueued at the start of a run like this one was, they make it again to the last bit.
  [[nodiscard]] std::span<const Command> commands_taken() const noexcept { return taken_; }

  /// Called at the opening of each step, before anybody moves: what is enqueued there takes effect
  /// in this very step.
  void at_opening(Scheduler::Client driver) { drivers_.push_back(std::move(driver)); }

  /// Who makes the physics of a vehicle that is hosted (`HostPhysics`): asked once in each step,
  /// after the vehicle's autopilot has said what to do and beside the other vehicles, for its state
  /// at the end of the step. What it answers is recorded as a `PutVehicle`; with nothing the
  /// vehicle stays as it is, or as the record has it. Called from any thread of the run.
  using HostedPhysics = std::function<std::optional<VehicleState<double>>(const HostedStep&)>;
  void host_physics(std::size_t agent, HostedPhysics physics, std::string source);

  /// Called at each barrier, after everything has moved.
  void at_barrier(Scheduler::Client observer) { scheduler_.at_barrier(std::move(observer)); }
  /// Another client of each step: reads the states as of the last barrier through `seen`, writes
  /// what is its own.
  void add_client(Scheduler::Client client) { scheduler_.add_client(std::move(client)); }

  /// For the thread of the run, as all that follows: who joins comes last. Its vehicles stay where
  /// they are in memory.
  [[nodiscard]] std::span<const Agent> agents() const noexcept { return agents_; }
  /// As of the last barrier.
  [[nodiscard]] const Seen& seen(std::size_t agent) const { return seen_[agent]; }
  /// Between steps: what is in force of a vehicle, and how far its own conduct has come; less work
  /// than `states`.
  [[nodiscard]] const HelmState& helm(std::size_t agent) const { return states_[agent].helm; }
  [[nodiscard]] const ConductState& conduct(std::size_t agent) const {
    return states_[agent].conduct;
  }
  /// Whether its energy is needed for its way home (helm.h).
  [[nodiscard]] bool must_come_home(std::size_t agent) const noexcept;
  [[nodiscard]] std::span<const Seen> seen() const noexcept { return seen_; }
  /// Between steps: all of every vehicle.
  [[nodiscard]] std::span<const AgentState> states();
  [[nodiscard]] double time_s() const noexcept;
  [[nodiscard]] std::uint64_t steps_made() const noexcept { return scheduler_.steps_made(); }
  [[nodiscard]] double step_s() const noexcept { return scheduler_.step_s(); }
  /// Between steps: a vehicle that is not stepped from now on. What it met, drew and felt stays.
  void retire(std::size_t index);
  [[nodiscard]] bool all_halted() const noexcept;
  /// One that conducts itself: halted, or at the end of it; of others there is nothing to wait for.
  [[nodiscard]] bool has_ended(std::size_t index) const noexcept;
  [[nodiscard]] bool all_ended() const noexcept;

  /// All that a run needs to go on as it would have.
  struct Checkpoint {
    std::uint64_t steps_made = 0;
    std::vector<AgentState> states;
    std::vector<Command> taken;
    std::vector<Command> waiting;
  };
  [[nodiscard]] Checkpoint checkpoint();
  /// Forgets the commands of this run for those of the checkpoint, and its newcomers for those of
  /// these commands, which are ready.
  /// @throws ContractViolation for that of another number of vehicles
  void restore(const Checkpoint& checkpoint);

 private:
  /// Up to eight vehicles of one kind and step. While they run, what of their state only the step
  /// itself needs lives in the block alone.
  struct Group {
    std::vector<std::size_t> agents;
    VehicleState<Eight> block;
    VehicleState<Eight> before;
    VehicleCommand<Eight> command;
    Surroundings<Eight> around;
    bool is_loaded = false;  ///< the block has the vehicles
    bool is_ahead = false;   ///< of their states
  };
  void load(Group& group);
  void unload(Group& group);
  void halt_lane(Group& group, std::size_t lane, const VehicleState<Eight>& last);
  void take_commands(const StepTime& time);
  void take_command(Command& command, const StepTime& time);
  void put_in_a_group(std::size_t agent);
  void join(const ReadyNewcomer& newcomer);
  void look_round(double t_s);
  void bring_back_newcomers(std::span<const Command> taken);
  void set_weather(const WeatherAsked& asked, double t_s);
  void bring_back_weather(std::span<const Command> taken);
  void mind_helms(const StepTime& time);
  void step_hosted(std::size_t agent, const StepTime& time);
  void note_hosted(const StepTime& time);
  void hear_watches(const StepTime& time);
  void meet_companies(const StepTime& time);
  void tick_behaviours(const StepTime& time);
  void publish();
  void step_any(Group& group, const StepTime& time);
  void step_group(Group& group, const StepTime& time);
  void step_one(std::size_t agent, const StepTime& time);

  std::size_t began_with_;     ///< vehicles
  std::size_t most_vehicles_;  ///< for which the lists below have room
  std::size_t most_in_block_;
  /// For any thread: those that are there, and with those that are on their way.
  std::atomic<std::size_t> there_, expected_;
  std::vector<Agent> agents_;
  std::vector<AgentState> states_;
  std::vector<Seen> seen_;
  std::vector<std::vector<std::size_t>> carried_;  ///< by each vehicle
  std::vector<Company> companies_;                 ///< of each, at its tick
  CommonPicture picture_;
  ApproachWatch approaches_;
  std::deque<Group> groups_;  ///< that does not move its members
  StepBlock block_;
  PullBlock pull_;
  CommandQueue commands_;
  std::vector<Scheduler::Client> drivers_;
  /// Of each vehicle whose physics are hosted.
  struct Hosted {
    HostedPhysics physics;
    std::string source;
    std::optional<VehicleState<double>> recorded;  ///< for this step
    std::optional<VehicleState<double>> answered;
  };
  std::vector<Hosted> hosted_;
  std::vector<Command> taken_;
  std::vector<StatusChange> changes_;  ///< of a tick: scratch
  Scheduler scheduler_;
};

}  // namespace slackwater::twin
