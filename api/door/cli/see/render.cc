#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "api/ask/render/rendered_run.h"
#include "api/door/cli/command.h"
#include "api/door/cli/output_file.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/see/looked_at.h"
#include "api/door/cli/see/rendered_files.h"
#include "api/door/cli/see/sight_options.h"
#include "api/door/live/topics/view_bag.h"
#include "api/program/named_sheet.h"
#include "api/show/report/html_page.h"
#include "fields/base/text.h"
#include "fields/base/whole_file.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

struct RenderArguments {
  RenderChoice choice;
  std::string at;
  std::string every;
  std::filesystem::path forecast;
  std::filesystem::path out;
  std::string by;  ///< a detector; empty: none
  std::filesystem::path html;
  std::filesystem::path findings;
  bool shows_truth = false;
  bool is_into_log = false;
  std::filesystem::path bag;
};

/// "12.5s", "5min", "1h30min".
double seconds_of(const std::string& text) {
  double seconds = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, problem] = std::from_chars(text.data(), end, seconds);
  if (problem == std::errc() && end - rest == 1 && *rest == 's' && seconds >= 0) return seconds;
  return std::chrono::duration<double>(parse_duration(text)).count();
}

/// "90s" after the start, or a UTC time.
double time_from(const std::string& text, const RenderedRun& run) {
  const auto read = [&](const std::string& given) {
    if (given.find('T') == std::string::npos) return seconds_of(given);
    return std::chrono::duration<double>(parse_utc(given) - run.start()).count();
  };
  return option_value("--at", text, read);
}

std::vector<double> moments_from(const RenderArguments& arguments, const RenderedRun& run) {
  if (arguments.at.empty() == arguments.every.empty())
    throw Error(ErrorKind::usage,
                "say when: one of --at (\"90s\" after the start, or a UTC time) and --every "
                "(\"10s\": from the log's start to its end)");
  if (!arguments.at.empty()) return {time_from(arguments.at, run)};
  const double step_s = option_value("--every", arguments.every, seconds_of);
  if (!(step_s > 0)) throw Error(ErrorKind::usage, "--every: expected more than 0 s");
  return moments_each(step_s, run, "--every");
}

void expect_detector(const RenderArguments& arguments) {
  if (arguments.by.empty() && arguments.is_into_log)
    throw Error(ErrorKind::usage, "--into-log: is of what a detector finds; name one with --by");
  for (const auto& [name, file] :
       {std::pair{"--html", &arguments.html}, {"--findings", &arguments.findings}})
    if (arguments.by.empty() && !file->empty())
      throw Error(ErrorKind::usage, std::string(name) +
                                        ": is about what a detector finds; name "
                                        "one with --by");
}

void run_render(const RenderArguments& arguments, const Context& context) {
  expect_detector(arguments);
  expect_output("--html", arguments.html, {".html"});
  expect_output("--findings", arguments.findings, {".geojson"});
  RenderChoice choice = arguments.choice;
  if (!arguments.forecast.empty()) choice.forecast = arguments.forecast;
  const RenderedRun run(choice, context.store_folder);
  const std::vector<double> times_s = moments_from(arguments, run);
  std::optional<LookedAt> looked_at;
  if (!arguments.by.empty())
    looked_at.emplace(arguments.by, run, choice.sensor, !arguments.html.empty());
  std::filesystem::path folder = arguments.out;
  if (folder.empty()) folder = choice.log.stem().string() + "-" + choice.sensor;
  RenderedFiles files(run, choice.sensor, folder);
  std::optional<live::ViewBag> bag;
  if (!arguments.bag.empty())
    bag.emplace(arguments.bag, run.start(), run.vehicle(), choice.sensor, run.sensor(),
                looked_at.has_value());
  for (const std::string& warning : run.warnings())
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  ProgressBar progress("render " + choice.log.filename().string(), context.json);
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const RenderView view = run.view_at(times_s[i]);
    files.add(view);
    std::vector<Detection> found;
    if (looked_at) found = looked_at->add(view);
    if (bag) bag->add(view, found);
    progress.update(static_cast<double>(i + 1) / static_cast<double>(times_s.size()));
  }
  files.finish();
  const std::uint64_t messages = bag ? bag->close() : 0;
  if (!arguments.html.empty()) write_page(looked_at->page(), arguments.html);
  if (!arguments.findings.empty())
    write_text(arguments.findings, looked_at->geojson(arguments.shows_truth));
  if (arguments.is_into_log) looked_at->record_in(choice.log);
  if (context.json) {
    json out = files.json();
    out["log"] = choice.log.string();
    if (looked_at) out["detected"] = looked_at->json();
    if (bag) out["bag"] = {{"path", arguments.bag.string()}, {"messages", messages}};
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return;
  }
  std::printf("%s", files.words().c_str());
  if (bag) std::printf("%s: %s\n", arguments.bag.c_str(), counted(messages, "message").c_str());
  if (looked_at) std::printf("%s", looked_at->words().c_str());
}

}  // namespace

void add_render(CLI::App& app, Context& context) {
  auto arguments = std::make_shared<RenderArguments>();
  CLI::App* command = app.add_subcommand(
      "render", "What a camera, lidar, sonar or ADCP saw on any run, from its log");
  command->add_option("log", arguments->choice.log, "FILE.nc of `slackwater simulate` or `live`")
      ->required();
  command->add_option("--sensor", arguments->choice.sensor, "name of a file in data/sensors")
      ->required();
  command->add_option("--at", arguments->at, "one time: 90s after the start, or UTC");
  command->add_option("--every", arguments->every, "a picture each so long, over the whole log");
  command->add_option("--vehicle", arguments->choice.vehicle,
                      "that carries it (default: the first in the sensor's medium)");
  command->add_option("--out", arguments->out, "folder of the pictures (default: LOG-SENSOR)");
  add_sight_options(*command, arguments->choice.sight);
  command->add_option("--forecast", arguments->forecast,
                      "file of the forecast it ran in (default: found in the store)");
  command->add_option("--by", arguments->by,
                      "a detector looks at the pictures: one of " +
                          joined(known_sheets("detectors"), ", ") + ", or a file of that form");
  command->add_option("--html", arguments->html,
                      "with --by: a page with the pictures, what was found and what is there");
  command->add_option("--findings", arguments->findings,
                      "with --by: what was found, as FILE.geojson");
  command->add_flag("--truth", arguments->shows_truth,
                    "with --findings: which of them are false alarms");
  command->add_flag("--into-log", arguments->is_into_log,
                    "with --by: what was found goes into the log, for `score` and its page");
  command->add_option("--bag", arguments->bag,
                      "bag of the same as messages of ROS 2: FILE.mcap, or a folder for rosbag2");
  command->add_option("--threads", arguments->choice.threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_render(*arguments, context); });
}

}  // namespace slackwater::api
