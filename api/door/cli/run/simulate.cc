#include <CLI/CLI.hpp>
#include <atomic>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/ask/run/resurvey.h"
#include "api/ask/run/scenario_at_hand.h"
#include "api/ask/run/scenario_run.h"
#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/run/recorded_run.h"
#include "api/door/cli/run/run_print.h"
#include "api/door/cli/see/see_by_sensors.h"
#include "api/log/log_csv.h"
#include "api/show/coverage/findings_file.h"
#include "api/show/rehearse/run_page.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct SimulateArguments {
  std::filesystem::path scenario;
  std::filesystem::path out;
  std::filesystem::path html;
  std::filesystem::path csv;
  std::filesystem::path findings;
  std::filesystem::path resurvey;
  bool shows_truth = false;
  double real_time = 0;
  std::size_t threads = 1;
  bool one_by_one = false;
  std::filesystem::path checkpoint;
  std::string checkpoint_at;
  std::filesystem::path restore;
  SeeingAsked see;
};

/// Set by SIGINT and SIGTERM while a run has a checkpoint to leave behind.
std::atomic<bool> stop_asked = false;
static_assert(std::atomic<bool>::is_always_lock_free);
void ask_to_stop(int) { stop_asked = true; }

RunChoice choice_of(const SimulateArguments& arguments) {
  RunChoice choice{arguments.threads, !arguments.one_by_one, arguments.real_time};
  choice.checkpoint = arguments.checkpoint;
  choice.restore = arguments.restore;
  if (!arguments.checkpoint_at.empty()) {
    if (arguments.checkpoint.empty())
      throw Error(ErrorKind::usage, "--checkpoint-at: say which file by --checkpoint");
    choice.checkpoint_at_s =
        std::chrono::duration<double>(
            option_value("--checkpoint-at", arguments.checkpoint_at,
                         [](const std::string& text) { return parse_duration(text); }))
            .count();
  }
  if (!arguments.checkpoint.empty()) {
    choice.is_stop_asked = &stop_asked;
    std::signal(SIGINT, ask_to_stop);
    std::signal(SIGTERM, ask_to_stop);
  }
  return choice;
}

/// What was found, as a file of the format that its name says; nothing without a name.
void write_findings(const ingest::TrajectoryFile& log, const std::filesystem::path& file,
                    bool shows_truth) {
  if (file.empty()) return;
  write_text(file, file.extension() == ".csv" ? findings_csv(log, {shows_truth})
                                              : findings_geojson(log, {shows_truth}));
}

/// What to fly again, also as the file that was asked for.
twin::Resurvey written_resurvey(const twin::Scenario& scenario, const ScenarioResult& result,
                                const std::filesystem::path& file) {
  if (file.empty()) return {};
  twin::Resurvey again = resurvey_of(scenario, result);
  if (!again.scenario)
    throw Error(ErrorKind::not_found,
                "--resurvey: nothing is left to fly again, or nothing was inspected; no file is "
                "written");
  write_text(file, again.scenario->yaml);
  return again;
}

/// Nothing where the forecast is of the store, or the water is made up.
std::optional<std::filesystem::path> forecast_file(const twin::Scenario& scenario,
                                                   const std::filesystem::path& folder) {
  const auto* water = std::get_if<twin::ForecastWater>(&scenario.water);
  if (water == nullptr || water->file.empty()) return std::nullopt;
  return folder / water->file;  // an absolute one stays what it is
}

void write_page_and_csv(const ingest::TrajectoryFile& log, const SimulateArguments& arguments) {
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_run_page(log, partial, {.shows_truth = arguments.shows_truth});
    });
  }
  if (!arguments.csv.empty()) write_log_csv(log, arguments.csv);
}

void run_simulate(const SimulateArguments& arguments, const Context& context) {
  expect_output("--out", arguments.out, {".nc"});
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  expect_output("--findings", arguments.findings, {".geojson", ".csv"});
  expect_output("--resurvey", arguments.resurvey, {".yaml"});
  expect_output("--checkpoint", arguments.checkpoint, {});
  const RunChoice choice = choice_of(arguments);
  const ScenarioAtHand at_hand = scenario_at_hand(arguments.scenario, context.store_folder);
  const twin::Scenario& scenario = at_hand.scenario;
  const ScenarioWater& water = at_hand.water;
  const std::vector<live::SensorAsked> sensors =
      sensors_to_see(arguments.see, arguments.out, scenario);
  ProgressBar progress("simulate " + scenario.name, context.json);
  const ScenarioResult result = with_context(arguments.scenario.string(), [&] {
    return run_scenario(scenario, water, choice, [&](double share) { progress.update(share); });
  });
  if (!arguments.out.empty()) {
    write_beside(arguments.out, [&](const std::filesystem::path& partial) {
      ingest::write_trajectories(result.file, partial);
    });
  }
  write_findings(result.file, arguments.findings, arguments.shows_truth);
  for (const std::string& warning : result.warnings)
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  print_notes(result.notes);
  const twin::Resurvey again = written_resurvey(scenario, result, arguments.resurvey);
  const SeenLog seen_log{arguments.out, arguments.see.by,
                         forecast_file(scenario, arguments.scenario.parent_path()),
                         arguments.threads};
  if (!context.json) {
    print_run(result, arguments.out);
    for (const std::string& line : again.words) std::printf("%s\n", line.c_str());
  }
  const json seen = see_by_sensors(sensors, seen_log, context);
  write_page_and_csv(
      arguments.see.by.empty() ? result.file : ingest::read_tracks_apart(arguments.out), arguments);
  if (!context.json) return;
  json out = run_json(result, scenario.name, water, arguments.out);
  if (!sensors.empty()) out["seen"] = seen;
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

struct ReplayArguments {
  std::filesystem::path log;
  std::filesystem::path forecast;
  std::filesystem::path html;
  std::filesystem::path csv;
  std::filesystem::path findings;
  bool shows_truth = false;
  std::vector<std::filesystem::path> recordings;
  std::size_t threads = 1;
};

json told_json(const live::RecordTold& told) {
  json kinds = json::array();
  for (const auto& [kind, share] : told.commands)
    kinds.push_back({{"kind", kind}, {"in_log", share.in_log}, {"recorded", share.told}});
  return {{"taken", kinds},
          {"refused",
           {{"in_log", told.refusals.in_log},
            {"recorded", told.refusals.told},
            {"messages", told.refusal_messages}}}};
}

void run_replay(const ReplayArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  expect_output("--findings", arguments.findings, {".geojson", ".csv"});
  if (!arguments.findings.empty())
    write_findings(ingest::read_tracks_apart(arguments.log), arguments.findings,
                   arguments.shows_truth);
  if (!arguments.csv.empty())
    write_log_csv(ingest::read_tracks_apart(arguments.log), arguments.csv);
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_run_page(ingest::read_tracks_apart(arguments.log), partial,
                     {.shows_truth = arguments.shows_truth});
    });
  }
  ProgressBar progress("replay " + arguments.log.filename().string(), context.json);
  std::optional<std::filesystem::path> forecast;
  if (!arguments.forecast.empty()) forecast = arguments.forecast;
  RunChoice choice{arguments.threads, true, 0};
  RecordedRun recorded(arguments.recordings, choice);
  const ReplayResult result = replay(arguments.log, context.store_folder, forecast, choice,
                                     [&](double share) { progress.update(share); });
  const Recordings& recordings = recorded.completed();
  const live::RecordTold& told = recorded.told();
  if (context.json) {
    json out = {{"log", arguments.log.string()},
                {"identical", result.is_identical},
                {"difference", result.is_identical ? json(nullptr) : json(result.difference)},
                {"wall_s", result.wall_s},
                {"recordings", recordings.json()}};
    if (!recordings.empty()) out["commands"] = told_json(told);
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    context.answered = true;
  } else if (result.is_identical) {
    std::printf("%s: replayed in %.2f s, the same to the byte\n", arguments.log.c_str(),
                result.wall_s);
    if (const std::string words = told.text(); !words.empty())
      std::printf("recorded: %s\n", words.c_str());
  }
  if (!result.is_identical) {
    throw Error(ErrorKind::invalid_input,
                arguments.log.string() + ": does not replay to the byte; " + result.difference);
  }
  recordings.expect_complete();
}

void add_findings_options(CLI::App& command, std::filesystem::path& findings, bool& shows_truth) {
  command.add_option("--findings", findings,
                     "what the inspection found, as FILE.geojson or FILE.csv");
  command.add_flag("--truth", shows_truth,
                   "in page and findings: what was planted and missed, which reports are false");
}

}  // namespace

void add_simulate(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<SimulateArguments>();
  CLI::App* command = app.add_subcommand(
      "simulate",
      "Run the vehicles of a scenario in a forecast, to the last bit the same each time");
  command->add_option("scenario", arguments->scenario, "YAML file")->required();
  command->add_option("--out", arguments->out, "log as FILE.nc (CF trajectories)");
  command->add_option("--html", arguments->html, "page of plots as FILE.html");
  command->add_option("--see", arguments->see.sensors,
                      "VEHICLE/SENSOR@RATE: what a sensor of data/sensors on it saw, RATE times a "
                      "second, in a folder beside the log; repeatable");
  command->add_option("--by", arguments->see.by,
                      "with --see: a detector of data/detectors, whose finds go into the log");
  command->add_option("--csv", arguments->csv,
                      "log as FILE.csv, a row a vehicle and time; its lists as FILE-NAME.csv");
  add_findings_options(*command, arguments->findings, arguments->shows_truth);
  command->add_option("--resurvey", arguments->resurvey,
                      "what was not covered, as a scenario FILE.yaml that flies there again");
  command
      ->add_option("--real-time", arguments->real_time,
                   "times as fast as the clock (default: as fast as the machine can)")
      ->check(CLI::Range(0.0, 1e6));
  command->add_option("--threads", arguments->threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->add_flag("--one-by-one", arguments->one_by_one,
                    "step vehicles singly: the same bits, slower");
  command->add_option(
      "--checkpoint", arguments->checkpoint,
      "FILE to leave the run in when stopped (SIGINT, SIGTERM) or at --checkpoint-at");
  command->add_option("--checkpoint-at", arguments->checkpoint_at,
                      "time since the start of the run, e.g. 5min");
  command->add_option("--restore", arguments->restore, "go on from the checkpoint in FILE");
  command->callback([arguments, &context] { run_simulate(*arguments, context); });
}

void add_replay(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<ReplayArguments>();
  CLI::App* command = app.add_subcommand("replay", "Prove that a log runs again to the same bytes");
  command->add_option("log", arguments->log, "FILE.nc of `slackwater simulate`")->required();
  command->add_option("--forecast", arguments->forecast,
                      "file of the forecast it ran in (default: found in the store)");
  command->add_option("--html", arguments->html, "page of plots of the log as FILE.html");
  command->add_option("--record", arguments->recordings,
                      "bag of what the run tells: FILE.mcap, or a folder for rosbag2; repeatable");
  command->add_option("--csv", arguments->csv,
                      "the log as FILE.csv, a row a vehicle and time; its lists as FILE-NAME.csv");
  add_findings_options(*command, arguments->findings, arguments->shows_truth);
  command->add_option("--threads", arguments->threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_replay(*arguments, context); });
}

}  // namespace slackwater::api
