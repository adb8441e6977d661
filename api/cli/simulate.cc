#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/cli/clearance_print.h"
#include "api/cli/command.h"
#include "api/cli/output_file.h"
#include "api/cli/progress.h"
#include "api/cli/traffic_print.h"
#include "api/rehearse/cleaning_report.h"
#include "api/rehearse/heard_traffic.h"
#include "api/rehearse/log_csv.h"
#include "api/rehearse/run_page.h"
#include "api/rehearse/scenario_run.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct SimulateArguments {
  std::filesystem::path scenario;
  std::filesystem::path out;
  std::filesystem::path html;
  std::filesystem::path csv;
  double real_time = 0;
  std::size_t threads = 1;
  bool one_by_one = false;
  std::filesystem::path checkpoint;
  std::string checkpoint_at;
  std::filesystem::path restore;
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

json events_json(const VehicleSummary& s) {
  json events = json::array();
  for (const FateEvent& event : s.events)
    events.push_back({{"what", event.what},
                      {"at_s", std::isfinite(event.at_s) ? json(event.at_s) : json(nullptr)}});
  return events;
}

/// "12.3 Wh" of a battery, "0.457 kWh" of what nobody described, "8.1 kg" of fuel.
std::string energy_text(const VehicleSummary& s) {
  if (s.burns_fuel && !s.has_battery) return formatted("{:.1f} kg", s.fuel_kg);
  return s.has_battery ? formatted("{:.1f} Wh", s.energy_wh)
                       : formatted("{:.3f} kWh", s.energy_wh / 1000);
}

json summary_json(const VehicleSummary& s) {
  return {{"name", s.name},
          {"model", s.model},
          {"sailed_m", s.sailed_m},
          {"energy_wh", s.is_electric ? json(s.energy_wh) : json(nullptr)},
          {"state_of_charge", s.has_battery ? json(s.state_of_charge) : json(nullptr)},
          {"least_voltage_v", s.has_battery ? json(s.least_voltage_v) : json(nullptr)},
          {"fuel_kg", s.burns_fuel ? json(s.fuel_kg) : json(nullptr)},
          {"rms_across_track_m", s.rms_across_track_m},
          {"rms_depth_error_m", s.floats ? json(nullptr) : json(s.rms_depth_error_m)},
          {"largest_depth_error_m", s.floats ? json(nullptr) : json(s.largest_depth_error_m)},
          {"largest_roll_deg", s.largest_roll_deg},
          {"largest_pitch_deg", s.largest_pitch_deg},
          {"waypoints", s.waypoints},
          {"tasks_done", s.tasks_done},
          {"tasks", s.tasks},
          {"navigation", s.by_sensors ? "sensors" : "truth"},
          {"navigation_error_m", s.by_sensors ? json(s.navigation_error_m) : json(nullptr)},
          {"rms_navigation_error_m", s.by_sensors ? json(s.rms_navigation_error_m) : json(nullptr)},
          {"cleaning", s.cleaning ? cleaning_json(*s.cleaning) : json(nullptr)},
          {"fate", s.fate.empty() ? json(nullptr) : json(s.fate)},
          {"events", events_json(s)},
          {"closest", closest_json(s.closest)},
          {"clearance", clearance_json(s)},
          {"halt", s.halt},
          {"halted_at_s", s.halt == "none" ? json(nullptr) : json(s.halted_at_s)}};
}

void print_summary(const ScenarioResult& result, const std::filesystem::path& out) {
  std::printf("%-16s %-16s %9s %11s %7s %9s %13s %10s %8s  %s\n", "vehicle", "model", "sailed m",
              "energy", "charge", "off m rms", "depth m, most", "roll/pitch", "tasks",
              "what befell it");
  for (const VehicleSummary& s : result.vehicles) {
    const std::string energy = energy_text(s);
    const std::string charge = s.has_battery ? formatted("{:.1f} %", 100 * s.state_of_charge) : "-";
    const std::string tasks = formatted("{} of {}", s.tasks_done, s.tasks);
    const std::string depth =
        s.floats ? "-" : formatted("{:.2f}, {:.2f}", s.rms_depth_error_m, s.largest_depth_error_m);
    const std::string tilt =
        formatted("{:.0f}/{:.0f} deg", s.largest_roll_deg, s.largest_pitch_deg);
    std::printf("%-16s %-16s %9.1f %11s %7s %9.2f %13s %10s %8s  %s\n", s.name.c_str(),
                s.model.c_str(), s.sailed_m, energy.c_str(), charge.c_str(), s.rms_across_track_m,
                depth.c_str(), tilt.c_str(), tasks.c_str(), s.fate.empty() ? "-" : s.fate.c_str());
  }
  for (const VehicleSummary& s : result.vehicles) {
    if (!s.by_sensors) continue;
    std::printf("%s took itself to be %.2f m from where it was at the end, %.2f m rms\n",
                s.name.c_str(), s.navigation_error_m, s.rms_navigation_error_m);
  }
  for (const VehicleSummary& s : result.vehicles)
    if (s.cleaning) std::printf("%s: %s\n", s.name.c_str(), cleaning_text(*s.cleaning).c_str());
  std::printf("%g s from %s in %.2f s (%.0f x real time)%s%s\n", result.duration_s,
              format_utc(result.start).c_str(), result.wall_s, result.duration_s / result.wall_s,
              out.empty() ? "" : "; log ", out.c_str());
}

void run_simulate(const SimulateArguments& arguments, const Context& context) {
  expect_output("--out", arguments.out, {".nc"});
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  expect_output("--checkpoint", arguments.checkpoint, {});
  const RunChoice choice = choice_of(arguments);
  const twin::Scenario scenario = twin::read_scenario(arguments.scenario);
  const auto folder = std::filesystem::absolute(arguments.scenario).parent_path();
  ScenarioWater water = water_of(scenario, context.store_folder, folder);
  with_context(arguments.scenario.string(), [&] { add_heard_traffic(scenario, folder, water); });
  ProgressBar progress("simulate " + scenario.name, context.json);
  const ScenarioResult result = with_context(arguments.scenario.string(), [&] {
    return run_scenario(scenario, water, choice, [&](double share) { progress.update(share); });
  });
  if (!arguments.out.empty()) {
    write_beside(arguments.out, [&](const std::filesystem::path& partial) {
      ingest::write_trajectories(result.file, partial);
    });
  }
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_run_page(result.file, partial);
    });
  }
  if (!arguments.csv.empty()) write_log_csv(result.file, arguments.csv);
  for (const std::string& warning : result.warnings)
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  if (!context.json) {
    print_summary(result, arguments.out);
    print_clearance(result);
    print_traffic(result);
    return;
  }
  json out = {{"scenario", scenario.name},
              {"start", format_utc(result.start)},
              {"duration_s", result.duration_s},
              {"wall_s", result.wall_s},
              {"forecast", water.forecast_name},
              {"forecast_sha256",
               water.forecast_sha256.empty() ? json(nullptr) : json(water.forecast_sha256)},
              {"log", arguments.out.empty() ? json(nullptr) : json(arguments.out.string())},
              {"warnings", result.warnings},
              {"vehicles", json::array()}};
  for (const VehicleSummary& s : result.vehicles) out["vehicles"].push_back(summary_json(s));
  out["traffic"] = traffic_json(result);
  std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
}

struct ReplayArguments {
  std::filesystem::path log;
  std::filesystem::path forecast;
  std::filesystem::path html;
  std::filesystem::path csv;
  std::size_t threads = 1;
};

void run_replay(const ReplayArguments& arguments, const Context& context) {
  expect_output("--html", arguments.html, {".html"});
  expect_output("--csv", arguments.csv, {".csv"});
  if (!arguments.csv.empty())
    write_log_csv(ingest::read_trajectories(arguments.log), arguments.csv);
  if (!arguments.html.empty()) {
    write_beside(arguments.html, [&](const std::filesystem::path& partial) {
      write_run_page(ingest::read_trajectories(arguments.log), partial);
    });
  }
  ProgressBar progress("replay " + arguments.log.filename().string(), context.json);
  std::optional<std::filesystem::path> forecast;
  if (!arguments.forecast.empty()) forecast = arguments.forecast;
  const ReplayResult result =
      replay(arguments.log, context.store_folder, forecast, {arguments.threads, true, 0},
             [&](double share) { progress.update(share); });
  if (context.json) {
    const json out = {{"log", arguments.log.string()},
                      {"identical", result.is_identical},
                      {"difference", result.is_identical ? json(nullptr) : json(result.difference)},
                      {"wall_s", result.wall_s}};
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    context.answered = true;
  } else if (result.is_identical) {
    std::printf("%s: replayed in %.2f s, the same to the byte\n", arguments.log.c_str(),
                result.wall_s);
  }
  if (!result.is_identical) {
    throw Error(ErrorKind::invalid_input,
                arguments.log.string() + ": does not replay to the byte; " + result.difference);
  }
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
  command->add_option("--csv", arguments->csv,
                      "log as FILE.csv, a row a vehicle and time; its lists as FILE-NAME.csv");
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
  command->add_option("--csv", arguments->csv,
                      "the log as FILE.csv, a row a vehicle and time; its lists as FILE-NAME.csv");
  command->add_option("--threads", arguments->threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_replay(*arguments, context); });
}

}  // namespace slackwater::api
