#include "api/ask/run/scenario_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

#include "api/ask/run/log_file.h"
#include "api/ask/run/run_observers.h"
#include "api/log/account_log.h"
#include "api/log/checkpoint_file.h"
#include "api/log/traffic_tables.h"
#include "api/program/version.h"
#include "fields/base/encode/sha256.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/agent/conduct.h"
#include "twin/agent/follow_tracks.h"
#include "twin/step/open_loop.h"

namespace slackwater::api {
namespace {

using twin::Agent;
using twin::AgentState;
using twin::RunLog;

std::optional<Inspected> inspected_by(const Agent& agent, const AgentState& state) {
  if (!agent.inspection) return std::nullopt;
  return Inspected{agent.inspection, state.inspection,
                   twin::inspection_outcome(*agent.inspection, state.inspection),
                   twin::inspection_findings(*agent.inspection, state.inspection).findings};
}

CheckpointOrigin checkpoint_origin(const twin::Scenario& scenario, const ScenarioWater& water,
                                   std::span<const twin::TrafficVessel> vessels) {
  return {code_version(), sha256_of_text(scenario.yaml), water.forecast_sha256,
          vehicle_checksums(scenario, water.surround.data_folder), traffic_checksum(vessels)};
}

/// A run with all that looks on.
struct WatchedRun {
  twin::Run& run;
  twin::TrafficWatch& watch;
  ScenarioResult& so_far;
  const twin::Scenario& scenario;
  const twin::NewcomerYard& newcomer_yard;
  const std::filesystem::path& data_folder;
  std::unique_ptr<twin::CommandArbiter> arbiter{};  ///< where somebody takes part
};

void expect_record(bool condition, std::string_view otherwise) {
  if (!condition)
    throw Error(ErrorKind::invalid_input,
                "a command of the record cannot be: " + std::string(otherwise));
}

/// Vehicles that joined by these commands, ready once more: nothing is read while the run goes on.
/// Each in the weather that was in force when it was asked for.
/// @param waiting  not taken yet, and their weather not in force
void make_ready(const twin::Run& run, const twin::NewcomerYard& newcomer_yard,
                std::vector<twin::Command>& taken, std::vector<twin::Command>& waiting) {
  const twin::Environment& environment = run.agents().front().water->environment();
  twin::WeatherInHand& weather = *environment.weather;
  const auto ready = [&](twin::Command& command) {
    auto* spawn = std::get_if<twin::Spawn>(&command.what);
    if (spawn == nullptr) return;
    with_context("vehicle " + spawn->newcomer.name,
                 [&] { spawn->ready = newcomer_yard.ready(spawn->newcomer, command.received_s); });
  };
  weather.forget();
  std::uint64_t last_step = 0;
  for (twin::Command& command : taken) {
    if (const auto* set = std::get_if<twin::SetWeather>(&command.what)) {
      const std::string problem = twin::problem_of(set->asked, environment);
      expect_record(problem.empty(), problem);
      expect_record(command.step >= last_step, "it comes before the weather that it follows");
      last_step = command.step;
      weather.set(set->asked, environment, static_cast<double>(command.step) * run.step_s());
    }
    ready(command);
  }
  for (twin::Command& command : waiting) ready(command);
  weather.forget();
}

std::size_t newcomers_in(std::span<const twin::Command> commands) {
  return static_cast<std::size_t>(std::count_if(
      commands.begin(), commands.end(),
      [](const twin::Command& c) { return std::holds_alternative<twin::Spawn>(c.what); }));
}

/// Of those that joined or are about to.
std::string newcomer_checksums(const twin::Run::Checkpoint& checkpoint,
                               const std::filesystem::path& data_folder) {
  std::vector<twin::Command> commands = checkpoint.taken;
  commands.insert(commands.end(), checkpoint.waiting.begin(), checkpoint.waiting.end());
  return vehicle_checksums({}, data_folder, commands);
}

void save(const WatchedRun& watched, const CheckpointOrigin& origin,
          const std::filesystem::path& file) {
  const twin::SensorLog& sensed = watched.so_far.sensed;
  const auto& arbiter = watched.arbiter;
  twin::Run::Checkpoint checkpoint = watched.run.checkpoint();
  std::string newcomers = newcomer_checksums(checkpoint, watched.data_folder);
  write_checkpoint(
      {std::move(checkpoint), watched.so_far.log, sensed.rows, sensed.last_s, watched.watch.state(),
       arbiter ? arbiter->refusals() : watched.so_far.refusals, std::move(newcomers)},
      origin, file);
}

/// Puts a run where a checkpoint stands, with what was logged until then.
void take_up(const std::filesystem::path& file, StandingRun standing, const WatchedRun& watched) {
  twin::Run& run = watched.run;
  ScenarioResult& result = watched.so_far;
  twin::Run::Checkpoint& checkpoint = standing.checkpoint;
  // Who joined since the last row has none yet.
  const std::size_t began_with = run.agents().size();
  const std::size_t vehicles = began_with + newcomers_in(checkpoint.taken);
  const auto fits = [&](std::size_t size) { return size >= began_with && size <= vehicles; };
  if (checkpoint.states.size() != vehicles || !fits(standing.log.rows.size()) ||
      !fits(standing.sensor_rows.size()) || !fits(standing.watch.alarms.size()) ||
      vehicles + newcomers_in(checkpoint.waiting) > run.most_vehicles()) {
    throw Error(ErrorKind::invalid_input,
                file.string() + ": holds another number of vehicles than the scenario");
  }
  with_context(file.string(), [&] {
    if (newcomer_checksums(checkpoint, watched.data_folder) != standing.newcomers)
      throw Error(ErrorKind::invalid_input,
                  "the files of vehicles that joined its run are others now; take it up with the "
                  "version that wrote it");
    make_ready(run, watched.newcomer_yard, checkpoint.taken, checkpoint.waiting);
  });
  run.restore(checkpoint);
  watched.watch.restore(std::move(standing.watch));
  result.log.rows.resize(std::max(result.log.rows.size(), standing.log.rows.size()));
  for (std::size_t i = 0; i < standing.log.rows.size(); ++i) {
    // Into the room that is kept for the whole run.
    auto& row = result.log.rows[i];
    row.insert(row.end(), standing.log.rows[i].begin(), standing.log.rows[i].end());
  }
  result.log.t_s.insert(result.log.t_s.end(), standing.log.t_s.begin(), standing.log.t_s.end());
  result.sensed.rows = std::move(standing.sensor_rows);
  result.sensed.times = standing.log.t_s.size();
  result.sensed.last_s = standing.last_sensor_row_s;
  result.refusals = std::move(standing.refusals);
}

/// What is done from outside: the record of a run, or who takes part in this one.
void let_in(const RunChoice& choice, const ScenarioWater& water, const twin::ReadyRun& ready,
            twin::RunControl& control, WatchedRun& watched) {
  twin::Run& run = watched.run;
  if (!choice.record.refusals.empty()) watched.so_far.refusals = choice.record.refusals;
  std::vector<twin::Command> commands = choice.record.commands, none;
  make_ready(run, watched.newcomer_yard, commands, none);
  std::vector<const Agent*> agents;
  for (const Agent& agent : run.agents()) agents.push_back(&agent);
  for (const twin::Command& command : commands) {
    if (const auto* spawn = std::get_if<twin::Spawn>(&command.what)) {
      expect_record(agents.size() < run.most_vehicles(),
                    "more vehicles join than there is room for");
      agents.push_back(&spawn->ready->agent);
    }
    expect_record(command.agent < agents.size(), "it is for a vehicle that has not joined yet");
    const std::string_view problem = twin::unsoundness_of(command, *agents[command.agent]);
    expect_record(problem.empty(), problem);
    run.enqueue(command);
  }
  if (!choice.on_ready) return;
  watched.arbiter = std::make_unique<twin::CommandArbiter>(run);
  watched.arbiter->restore(watched.so_far.refusals);
  choice.on_ready({run, control, *watched.arbiter, watched.scenario, water, ready.start,
                   ready.origin, ready.environment, watched.so_far.vessels, watched.watch,
                   watched.newcomer_yard, choice.record});
}

/// Tells whoever took part that it is over.
struct Farewell {
  const std::function<void()>& on_over;
  ~Farewell() {
    if (on_over) on_over();
  }
};

/// The step at whose end the checkpoint is due; 0: none is.
/// @throws Error(usage) for a time that the run does not reach
std::uint64_t due_step(const twin::Scenario& scenario, const RunChoice& choice,
                       const twin::Run& run) {
  if (!choice.checkpoint_at_s) return 0;
  const double at_s = *choice.checkpoint_at_s;
  if (at_s > run.time_s() && at_s < scenario.duration_s) {
    const auto step = static_cast<std::uint64_t>(std::llround(at_s / scenario.step_s));
    return std::max(step, run.steps_made() + 1);
  }
  throw Error(ErrorKind::usage,
              formatted("--checkpoint-at: found {:g} s, the run goes from {:g} to {:g} s", at_s,
                        run.time_s(), scenario.duration_s));
}

twin::RunSettings settings_of(const twin::Scenario& scenario, const RunChoice& choice) {
  twin::RunSettings settings;
  settings.seed = scenario.seed;
  settings.step_s = scenario.step_s;
  settings.threads = choice.threads;
  settings.is_batch = choice.is_batch;
  settings.most_newcomers = most_newcomers;
  return settings;
}

twin::TrafficWatch watch_of(const twin::Scenario& scenario, const twin::ReadyRun& ready) {
  std::vector<std::vector<std::uint32_t>> not_of_concern;
  for (const Agent& agent : ready.agents) not_of_concern.push_back(twin::followed_by(agent));
  return {ready.vessels, scenario.traffic.alarm, std::move(not_of_concern)};
}

/// What is known before the first step.
ScenarioResult begun(const ScenarioWater& water, const twin::ReadyRun& ready) {
  ScenarioResult result;
  result.account.start = ready.start;
  result.warnings = water.warnings;
  result.warnings.insert(result.warnings.end(), ready.warnings.begin(), ready.warnings.end());
  result.notes = notes_of(ready.agents);
  result.vessels = ready.vessels;
  return result;
}

/// What is known after the last one.
void conclude(const WatchedRun& watched, const ScenarioWater& water, const GeoPoint& origin) {
  auto& [run, watch, result, scenario, newcomer_yard, data_folder, arbiter] = watched;
  const auto agents = run.agents();
  result.account.ran_s = run.time_s();
  result.commands.assign(run.commands_taken().begin(), run.commands_taken().end());
  if (arbiter) result.refusals = arbiter->refusals();
  result.log.let_join(agents.size());
  result.sensed.let_join(agents.size());
  const twin::EndedRun ended{agents, run.states(), scenario.structures, run.time_s()};
  for (std::size_t i = 0; i < agents.size(); ++i) {
    result.account.vehicles.push_back(twin::account_of(ended, i));
    result.inspected.push_back(inspected_by(agents[i], ended.states[i]));
  }
  result.alarms.assign(watch.records().begin(), watch.records().end());
  result.followed = tracks_followed(agents, result.log);
  result.file = log_file_of(scenario, water, origin, result, agents);
  for (std::size_t i = 0; i < agents.size(); ++i)
    twin::add_rows(rows_of(result.file, i), result.account.vehicles[i]);
  add_tables(scenario, result);
}

}  // namespace

std::vector<std::string> notes_of(std::span<const twin::Agent> agents) {
  std::vector<std::string> notes;
  std::set<const twin::Vehicle*> told;
  for (const twin::Agent& agent : agents)
    if (told.insert(agent.vehicle.get()).second)
      if (const std::string words = words_of(twin::open_loop_of(*agent.vehicle)); !words.empty())
        notes.push_back(agent.vehicle->id + ": " + words);
  return notes;
}

ScenarioResult run_scenario(const twin::Scenario& scenario, const ScenarioWater& water,
                            const RunChoice& choice,
                            const std::function<void(double)>& on_progress) {
  const auto started = std::chrono::steady_clock::now();
  twin::ReadyRun ready = twin::set_up(scenario, water.surround);
  ScenarioResult result = begun(water, ready);
  twin::TrafficWatch watch = watch_of(scenario, ready);
  const CheckpointOrigin origin = checkpoint_origin(scenario, water, ready.vessels);
  // Before the run, which may have threads: what reads a stranger's file is a copy of this process.
  std::optional<StandingRun> standing;
  if (!choice.restore.empty()) standing = read_checkpoint(choice.restore, origin);
  twin::Run run(std::move(ready.agents), std::move(ready.states), settings_of(scenario, choice));
  const auto whole_steps = [&](double time_s) { return std::llround(time_s / scenario.step_s); };
  const auto steps = static_cast<std::uint64_t>(whole_steps(scenario.duration_s));
  const auto every = static_cast<std::uint64_t>(std::max(1LL, whole_steps(scenario.log_every_s)));
  result.log.reserve(run.agents().size(), steps / every + 2);
  result.sensed = twin::SensorLog(run.agents(), scenario.logs_sensors, scenario.seed);

  const twin::NewcomerYard newcomer_yard(scenario, water.surround.data_folder,
                                         std::move(ready.vehicles), run.agents());
  WatchedRun watched{run, watch, result, scenario, newcomer_yard, water.surround.data_folder};
  const Recorder recorder{run, result.log, result.sensed};
  if (standing)
    take_up(choice.restore, *std::move(standing), watched);
  else
    recorder.record(0);

  // At each barrier, in this order.
  twin::RunControl own_control(choice.real_time_factor);
  twin::RunControl& control = choice.control != nullptr ? *choice.control : own_control;
  const StopWatcher stop{choice.is_stop_asked, control};
  const auto leave_checkpoint = [&] { save(watched, origin, choice.checkpoint); };
  const std::uint64_t due = due_step(scenario, choice, run);
  if (!ready.vessels.empty()) twin::keep_watch(watch, run, scenario.step_s);
  run.at_barrier(stop);
  run.at_barrier(EachNth{every, recorder});
  run.at_barrier(EachNth{every, ProgressReporter{on_progress, steps}});
  run.at_barrier(EachNth{every, HaltWatcher{run, control}});
  run.at_barrier(Checkpointer{due, control, leave_checkpoint});
  {
    const Farewell farewell{choice.on_over};
    let_in(choice, water, ready, control, watched);
    const std::uint64_t until = choice.record.stopped_at_step.value_or(steps);
    run.run_until(static_cast<double>(std::min(until, steps)) * scenario.step_s, control);
  }

  if (stop.is_asked()) {
    leave_checkpoint();
    throw Error(ErrorKind::unavailable, "stopped at " + std::to_string(run.time_s()) +
                                            " s of the run; go on with --restore " +
                                            choice.checkpoint.string());
  }
  if (run.steps_made() < steps && !run.all_halted()) result.stopped_at_step = run.steps_made();
  result.actions = choice.actions ? choice.actions() : choice.record.actions;
  conclude(watched, water, ready.origin);
  result.wall_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
  return result;
}

}  // namespace slackwater::api
