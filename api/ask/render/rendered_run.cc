#include "api/ask/render/rendered_run.h"

#include <algorithm>

#include "api/ask/render/logged_poses.h"
#include "api/ask/render/seen_run.h"
#include "api/ask/run/logged_water.h"
#include "api/log/command_tables.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/read_tracks_apart.h"

namespace slackwater::api {
namespace {

std::vector<twin::Command> view_commands_in(const ingest::TrajectoryFile& log) {
  std::vector<twin::Command> commands = commands_in(log);
  std::erase_if(commands, [](const twin::Command& command) { return !changes_the_view(command); });
  return commands;
}

}  // namespace

struct RenderedRun::Parts {
  RenderChoice choice;
  ingest::TrajectoryFile log;
  twin::Scenario scenario;
  LoggedPoses poses;
  ScenarioWater water;
  MountedSensor mounted;
  SeenRun run;
  std::vector<twin::Command> commands;
  std::vector<std::string> warnings;

  Parts(const RenderChoice& chosen, const std::filesystem::path& store_folder)
      : choice(chosen),
        log(ingest::read_tracks_apart(chosen.log)),
        scenario(scenario_of_log(log, chosen.log)),
        poses(log),
        water(logged_water(log, scenario, store_folder, chosen.forecast)),
        mounted(mounted_sensor(chosen.sensor, 0, chosen.sight, water.surround.data_folder)),
        run(scenario, water.surround, log.names),
        commands(view_commands_in(log)) {
    mounted.vehicle = chosen_vehicle();
    mounted.threads = chosen.threads;
    warnings = run.warnings(mounted.vehicle);
  }

  [[nodiscard]] std::size_t chosen_vehicle() const {
    const auto named = std::find(log.names.begin(), log.names.end(), choice.vehicle);
    if (!choice.vehicle.empty() && named == log.names.end())
      throw Error(ErrorKind::not_found,
                  formatted("{}: found no vehicle {}; it has {}", choice.log.string(),
                            choice.vehicle, joined(log.names, ", ")));
    if (!choice.vehicle.empty()) return static_cast<std::size_t>(named - log.names.begin());
    const twin::RenderSensor& sensor = mounted.sensor;
    for (std::size_t i = 0; i < log.names.size(); ++i) {
      const auto there = poses.at(i, poses.from_s());
      if (!there) continue;
      const bool is_under_water = there->position_m.z > 0;
      if (sensor.medium == twin::SensorMedium::both ||
          (sensor.medium == twin::SensorMedium::water) == is_under_water)
        return i;
    }
    throw Error(ErrorKind::not_found,
                formatted("{}: found no vehicle in {} at its start, which {} needs; name one of "
                          "{} by --vehicle",
                          choice.log.string(), twin::name_of(sensor.medium), sensor.name,
                          joined(log.names, ", ")));
  }
};

RenderedRun::RenderedRun(const RenderChoice& choice, const std::filesystem::path& store_folder)
    : parts_(std::make_unique<Parts>(choice, store_folder)) {}
RenderedRun::~RenderedRun() = default;

const twin::RenderSensor& RenderedRun::sensor() const noexcept { return parts_->mounted.sensor; }
const std::string& RenderedRun::vehicle() const noexcept {
  return parts_->log.names[parts_->mounted.vehicle];
}
const std::string& RenderedRun::title() const noexcept { return parts_->scenario.name; }
GeoPoint RenderedRun::origin() const noexcept { return parts_->run.origin(); }
UtcTime RenderedRun::start() const noexcept { return parts_->run.start(); }
double RenderedRun::from_s() const noexcept { return parts_->poses.from_s(); }
double RenderedRun::to_s() const noexcept { return parts_->poses.to_s(); }
const std::vector<std::string>& RenderedRun::warnings() const noexcept { return parts_->warnings; }

RenderView RenderedRun::view_at(double t_s) const {
  const Parts& parts = *parts_;
  if (!(t_s >= from_s() && t_s <= to_s()))
    throw Error(
        ErrorKind::invalid_input,
        formatted("found {:g} s, expected a time of the run, {:g} to {:g} s after its start", t_s,
                  from_s(), to_s()));
  std::vector<std::optional<twin::Carriage>> vehicles;
  for (std::size_t i = 0; i < parts.log.names.size(); ++i)
    vehicles.push_back(parts.poses.at(i, t_s));
  if (!vehicles[parts.mounted.vehicle])
    throw Error(ErrorKind::invalid_input,
                formatted("{} was not there at {:g} s: it joined later, or had come to grief",
                          vehicle(), t_s));
  return parts.run.look(parts.mounted, {t_s, vehicles, parts.commands});
}

}  // namespace slackwater::api
