#pragma once
#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "api/ask/run/track_following.h"
#include "api/log/inspected.h"
#include "data/store/session_action.h"
#include "ingest/cf/trajectory_file.h"
#include "twin/account/vehicle_account.h"
#include "twin/helm/command_arbiter.h"
#include "twin/mission/site_work.h"
#include "twin/run/newcomer_yard.h"
#include "twin/run/run_control.h"
#include "twin/run/run_log.h"
#include "twin/run/sensor_log.h"
#include "twin/run/set_up.h"
#include "twin/run/traffic_watch.h"
#include "twin/scenario/scenario.h"

namespace slackwater::api {

/// The water of a scenario, with the name under which it is found again.
struct ScenarioWater {
  twin::Surround surround;
  std::string forecast_sha256;     ///< empty: made up
  std::string forecast_name;       ///< "site 2025-06-01, issued ...", for people
  std::size_t members_issued = 0;  ///< of it; the field may hold more, drawn since
  twin::SiteLines lines;           ///< of the site, about the scenario's origin
  std::string traffic_files;       ///< logs of AIS and their checksums; empty: none
  std::vector<std::string> warnings;
};

/// Finds the forecast a scenario asks for: in the store, or the file it names (paths that are not
/// absolute count from `scenario_folder`). @throws Error(not_found), Error(invalid_input)
[[nodiscard]] ScenarioWater water_of(const twin::Scenario& scenario,
                                     const std::filesystem::path& store_folder,
                                     const std::filesystem::path& scenario_folder);
/// The water of a forecast that is at hand.
/// @param sha256  of its file
[[nodiscard]] ScenarioWater water_of(std::shared_ptr<const Snapshot> forecast,
                                     const std::string& sha256);
/// Gives a forecast at least so many members, the central one among them: those beyond what was
/// issued are drawn from the stored calibration (`with_further_members`); neither its file nor the
/// store is touched. Nothing for made-up water, whose futures differ in their seed alone.
/// @throws Error(unavailable) where they cannot be drawn, saying why
void hold_members(ScenarioWater& water, std::size_t members,
                  const std::filesystem::path& store_folder, int threads);
/// The forecast of a log: by its checksum, in the store. @param file  where given, this one
[[nodiscard]] ScenarioWater water_of_log(const twin::Scenario& scenario,
                                         const std::string& forecast_sha256,
                                         const std::filesystem::path& store_folder,
                                         const std::optional<std::filesystem::path>& file);

/// How the models of a run go with nobody at their controls, each once, by its id.
[[nodiscard]] std::vector<std::string> notes_of(std::span<const twin::Agent> agents);

struct ScenarioResult {
  twin::RunAccount account;
  double wall_s = 0;
  twin::RunLog log;
  twin::SensorLog sensed;
  std::vector<std::optional<Inspected>>
      inspected;                             ///< of each vehicle; nothing: it inspects nothing
  std::vector<twin::TrafficVessel> vessels;  ///< the traffic
  std::vector<twin::AlarmRecord> alarms;
  std::vector<TrackFollowing> followed;
  std::vector<std::string> warnings;
  std::vector<std::string> notes;                ///< of its vehicles with nobody at their controls
  std::vector<twin::Command> commands;           ///< that were taken from outside
  std::vector<twin::RefusalCount> refusals;      ///< of those that were not
  std::vector<store::SessionAction> actions;     ///< of people, taken or not
  std::optional<std::uint64_t> stopped_at_step;  ///< ended from outside, before its time
  ingest::TrajectoryFile file;                   ///< the log as it is written
};

/// What was done to a run from outside, so that it is made again.
struct RunRecord {
  std::vector<twin::Command> commands;
  std::vector<twin::RefusalCount> refusals;
  std::optional<std::uint64_t> stopped_at_step;
  std::vector<store::SessionAction> actions;  ///< of people
};

/// A run that is about to begin, in the hands of who takes part in it: `slackwater live`. All of it
/// is there until `RunChoice::on_over` returns.
struct RunInHand {
  twin::Run& run;  ///< looked on with `at_barrier` and driven with `at_opening`
  twin::RunControl& control;
  twin::CommandArbiter& arbiter;  ///< the way in for commands
  const twin::Scenario& scenario;
  const ScenarioWater& water;
  UtcTime start;
  GeoPoint origin;
  std::shared_ptr<const twin::Environment> environment;
  std::span<const twin::TrafficVessel> vessels;  ///< the traffic
  const twin::TrafficWatch& watch;               ///< whom its vehicles are alarmed about
  const twin::NewcomerYard& newcomer_yard;       ///< for vehicles that join it
  const RunRecord& record;                       ///< of a run that is made again
};

/// Vehicles that may join a run while it goes on.
inline constexpr std::size_t most_newcomers = 64;

struct RunChoice {
  std::size_t threads = 1;
  bool is_batch = true;
  double real_time_factor = 0;              ///< 0: as fast as possible
  std::filesystem::path checkpoint{};       ///< written at `checkpoint_at_s` and when asked to stop
  std::optional<double> checkpoint_at_s{};  ///< since the start of the run
  std::filesystem::path restore{};          ///< a checkpoint to go on from
  const std::atomic<bool>* is_stop_asked = nullptr;  ///< looked at once a step
  twin::RunControl* control = nullptr;               ///< null: of its own, at `real_time_factor`
  /// Called once before the first step, after all that looks on has joined the run; what joins in
  /// it comes last at each barrier.
  std::function<void(const RunInHand&)> on_ready{};
  std::function<void()> on_over{};  ///< after the last step, also where it failed
  /// What people did, asked for after `on_over`; absent: as the record has it.
  std::function<std::vector<store::SessionAction>()> actions{};
  RunRecord record{};  ///< of a run that is made again
};

/// Runs a scenario to its end, or until its control is told to stop. Nothing of the choice changes
/// what comes out but commands, and an end before its time: a run that goes on from a checkpoint
/// leaves the log of one that was never interrupted.
/// @throws Error(unavailable) where it was asked to stop, which names the checkpoint that it left
[[nodiscard]] ScenarioResult run_scenario(const twin::Scenario& scenario,
                                          const ScenarioWater& water, const RunChoice& choice,
                                          const std::function<void(double)>& on_progress = {});

/// What a replay found.
struct ReplayResult {
  bool is_identical = false;
  std::string difference;  ///< the first one, where there is
  double wall_s = 0;
};
/// Runs the scenario that a log holds again and compares the bytes of the two files.
/// @throws Error(invalid_input) for what is no log, Error(not_found) where its forecast or a
/// vehicle is gone or changed
[[nodiscard]] ReplayResult replay(const std::filesystem::path& log,
                                  const std::filesystem::path& store_folder,
                                  const std::optional<std::filesystem::path>& forecast,
                                  const RunChoice& choice,
                                  const std::function<void(double)>& on_progress = {});

}  // namespace slackwater::api
