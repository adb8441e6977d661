#include "api/door/cli/see/see_by_sensors.h"

#include <algorithm>
#include <cstdio>

#include "api/ask/render/rendered_run.h"
#include "api/door/cli/progress.h"
#include "api/door/cli/see/looked_at.h"
#include "api/door/cli/see/rendered_files.h"
#include "api/perception/detector.h"
#include "api/program/paths.h"
#include "fields/base/error.h"

namespace slackwater::api {

std::vector<live::SensorAsked> sensors_to_see(const SeeingAsked& wanted,
                                              const std::filesystem::path& log,
                                              const twin::Scenario& scenario) {
  if (!wanted.sensors.empty() && log.empty())
    throw Error(ErrorKind::usage,
                "--see: looks at the log of the run; say where it is to be, by --out");
  std::vector<live::SensorAsked> asked;
  bool has_camera = false;
  for (const std::string& text : wanted.sensors) {
    asked.push_back(live::sensor_asked(text));
    const auto& vehicles = scenario.vehicles;
    const bool is_there = std::any_of(
        vehicles.begin(), vehicles.end(),
        [&](const twin::ScenarioVehicle& one) { return one.name == asked.back().vehicle; });
    with_context("--see " + text, [&] {
      if (!is_there)
        throw Error(ErrorKind::not_found, "found no vehicle " + asked.back().vehicle +
                                              " in the scenario, expected one of its names");
      has_camera |= twin::read_named_render_sensor(asked.back().sensor, data_folder()).is_camera();
    });
  }
  if (!wanted.by.empty()) {
    if (!has_camera)
      throw Error(ErrorKind::usage,
                  "--by: looks at what a camera saw; name one with --see VEHICLE/SENSOR@RATE");
    (void)load_detector(wanted.by);
  }
  return asked;
}

nlohmann::json see_by_sensors(const std::vector<live::SensorAsked>& sensors, const SeenLog& of,
                              const Context& context) {
  nlohmann::json seen = nlohmann::json::array();
  for (const live::SensorAsked& asked : sensors) {
    const std::string name = asked.vehicle + "/" + asked.sensor;
    with_context("--see " + name, [&] {
      RenderChoice choice;
      choice.log = of.log;
      choice.sensor = asked.sensor;
      choice.vehicle = asked.vehicle;
      choice.forecast = of.forecast;
      choice.threads = static_cast<int>(std::min<std::size_t>(of.threads, 64));
      const RenderedRun run(choice, context.store_folder);
      for (const std::string& warning : run.warnings())
        std::fprintf(stderr, "slackwater: %s: %s\n", name.c_str(), warning.c_str());
      std::filesystem::path folder = of.log;
      folder.replace_filename(of.log.stem().string() + "-" + asked.vehicle + "-" + asked.sensor);
      RenderedFiles files(run, asked.sensor, folder);
      const std::vector<double> times_s = moments_each(1 / asked.rate_hz, run, "--see");
      std::optional<LookedAt> looked_at;
      if (!of.by.empty() && run.sensor().is_camera())
        looked_at.emplace(of.by, run, asked.sensor, false);
      ProgressBar progress("see " + name, context.json);
      for (std::size_t i = 0; i < times_s.size(); ++i) {
        const RenderView view = run.view_at(times_s[i]);
        files.add(view);
        if (looked_at) (void)looked_at->add(view);
        progress.update(static_cast<double>(i + 1) / static_cast<double>(times_s.size()));
      }
      files.finish();
      if (looked_at) looked_at->record_in(of.log);
      if (!context.json)
        std::printf("%s%s", files.words().c_str(), looked_at ? looked_at->words().c_str() : "");
      seen.push_back(files.json());
      if (looked_at) seen.back()["detected"] = looked_at->json();
    });
  }
  return seen;
}

}  // namespace slackwater::api
