#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>

#include "api/ask/render/rendered_run.h"
#include "api/door/cli/command.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/sight_options.h"
#include "api/show/render/picture_labels.h"
#include "api/show/render/view_file.h"
#include "api/show/render/waterfall.h"
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
};

constexpr std::size_t most_frames = 100000;

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
  const double frames = std::floor((run.to_s() - run.from_s()) / step_s + 1e-9) + 1;
  if (frames > static_cast<double>(most_frames))
    throw Error(ErrorKind::usage, formatted("--every: makes {:.0f} pictures, expected {} at most; "
                                            "take a longer step",
                                            frames, most_frames));
  std::vector<double> times_s;
  for (std::size_t i = 0; i < static_cast<std::size_t>(frames); ++i)
    times_s.push_back(std::min(run.from_s() + static_cast<double>(i) * step_s, run.to_s()));
  return times_s;
}

/// SENSOR_000012.500: in the order of time.
std::string name_at(const std::string& sensor, double t_s) {
  return formatted("{}_{:010.3f}", sensor, t_s);
}

json json_of(const RenderView& view, const std::string& name) {
  json out = {{"t_s", view.t_s},
              {"time", format_utc(view.time)},
              {"netcdf", name + ".nc"},
              {"position_enu_m",
               {view.pose.position_m.y, view.pose.position_m.x, -view.pose.position_m.z}}};
  if (!Waterfall::has_line(view)) out["png"] = name + ".png";
  const auto* camera = std::get_if<CameraView>(&view.seen);
  const auto* infrared = std::get_if<InfraredView>(&view.seen);
  if (camera == nullptr && infrared == nullptr) return out;
  if (camera != nullptr && camera->right) out["right_png"] = name + "_right.png";
  const twin::TruthFrame& truth = camera != nullptr ? camera->truth : infrared->truth;
  std::map<std::string, std::size_t> classes;
  for (const twin::SeenClass seen : truth.seen_class) ++classes[twin::name_of(seen)];
  out["pixels"] = classes;
  out["defects"] = json::array();
  for (const SeenDefect& defect : view.defects)
    if (defect.pixels > 0)
      out["defects"].push_back({{"number", defect.number},
                                {"kind", twin::name_of(defect.kind)},
                                {"surface", defect.surface},
                                {"size_m", defect.size_m},
                                {"pixels", defect.pixels}});
  return out;
}

std::size_t defects_in(const RenderView& view) {
  return static_cast<std::size_t>(std::count_if(view.defects.begin(), view.defects.end(),
                                                [](const SeenDefect& d) { return d.pixels > 0; }));
}

void run_render(const RenderArguments& arguments, const Context& context) {
  RenderChoice choice = arguments.choice;
  if (!arguments.forecast.empty()) choice.forecast = arguments.forecast;
  const RenderedRun run(choice, context.store_folder);
  const std::vector<double> times_s = moments_from(arguments, run);
  std::filesystem::path folder = arguments.out;
  if (folder.empty()) folder = choice.log.stem().string() + "-" + choice.sensor;
  std::error_code problem;
  std::filesystem::create_directories(folder, problem);
  if (problem)
    throw Error(ErrorKind::unavailable,
                "--out: cannot make the folder " + folder.string() + ": " + problem.message());
  for (const std::string& warning : run.warnings())
    std::fprintf(stderr, "slackwater: %s\n", warning.c_str());
  ProgressBar progress("render " + choice.log.filename().string(), context.json);
  json frames = json::array();
  PictureLabels labels;
  Waterfall waterfall;
  std::size_t with_defects = 0;
  for (std::size_t i = 0; i < times_s.size(); ++i) {
    const RenderView view = run.view_at(times_s[i]);
    const std::string name = name_at(choice.sensor, view.t_s);
    write_view_netcdf(view, run, folder / (name + ".nc"));
    if (Waterfall::has_line(view))
      waterfall.add(view);
    else
      write_view_png(view, folder / (name + ".png"));
    (void)write_right_png(view, folder / (name + "_right.png"));
    labels.add(view, name + ".png");
    with_defects += defects_in(view) > 0 ? 1 : 0;
    if (context.json) frames.push_back(json_of(view, name));
    progress.update(static_cast<double>(i + 1) / static_cast<double>(times_s.size()));
  }
  if (!labels.coco().at("images").empty())
    write_text(folder / (choice.sensor + "_labels.json"), labels.coco().dump() + "\n");
  const std::string waterfall_png = choice.sensor + "_waterfall.png";
  if (!waterfall.is_empty()) waterfall.write(folder / waterfall_png);
  if (context.json) {
    json out = {{"log", choice.log.string()}, {"sensor", choice.sensor},
                {"vehicle", run.vehicle()},   {"folder", folder.string()},
                {"warnings", run.warnings()}, {"frames", frames}};
    if (!waterfall.is_empty()) out["waterfall"] = waterfall_png;
    std::printf("%s\n", out.dump(2, ' ', false, json::error_handler_t::replace).c_str());
    return;
  }
  if (!waterfall.is_empty()) {
    std::printf("%s of %s: %zu ping%s in %s, a .nc each, and %s\n", run.sensor().name.c_str(),
                run.vehicle().c_str(), times_s.size(), times_s.size() == 1 ? "" : "s",
                folder.c_str(), waterfall_png.c_str());
    return;
  }
  std::printf("%s of %s: %zu picture%s in %s, a .png and a .nc each", run.sensor().name.c_str(),
              run.vehicle().c_str(), times_s.size(), times_s.size() == 1 ? "" : "s",
              folder.c_str());
  if (with_defects > 0) std::printf("; planted defects in %zu of them", with_defects);
  std::printf("\n");
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
  command->add_option("--threads", arguments->choice.threads, "1 to 64 (default 1)")
      ->check(CLI::Range(1, 64));
  command->callback([arguments, &context] { run_render(*arguments, context); });
}

}  // namespace slackwater::api
