#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "api/door/people/playback/logged_run.h"
#include "api/log/account_of_rows.h"
#include "api/log/action_tables.h"
#include "api/log/command_tables.h"
#include "api/log/table_reader.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "ingest/apart/read_tracks_apart.h"
#include "twin/agent/conduct.h"
#include "twin/body/attitude.h"
#include "twin/run/set_up.h"

// A log becomes the values that are shown of it.

namespace slackwater::people {
namespace {

using ingest::TrajectoryFile;

[[noreturn]] void refuse(const std::string& why) {
  throw Error(ErrorKind::invalid_input,
              why + "; give a log that `slackwater simulate` or `live` wrote");
}

/// A variable of the log, of which a vehicle has `per` numbers at a time; no number where the log
/// has no such variable.
class Column {
 public:
  Column(const TrajectoryFile& log, std::string_view name, std::size_t per = 1)
      : variable_(log.find(name)), times_(log.t_s.size()) {
    if (variable_ == nullptr || (variable_->per == per && is_whole(log))) return;
    refuse(formatted("found {} numbers of {} a vehicle and time, expected {}", variable_->per, name,
                     per));
  }
  [[nodiscard]] bool is_there() const noexcept { return variable_ != nullptr; }
  [[nodiscard]] double at(std::size_t vehicle, std::size_t row, std::size_t i = 0) const {
    if (variable_ == nullptr) return constants::nan;
    return variable_->values[(vehicle * times_ + row) * variable_->per + i];
  }

 private:
  [[nodiscard]] bool is_whole(const TrajectoryFile& log) const {
    return variable_->values.size() == log.names.size() * times_ * variable_->per;
  }
  const TrajectoryFile::Variable* variable_;
  std::size_t times_;
};

float narrow(double value) { return static_cast<float>(value); }
double or_zero(double value) { return std::isfinite(value) ? value : 0; }

/// The columns that rows are made of.
class Rows {
 public:
  explicit Rows(const TrajectoryFile& log)
      : x_(log, "x"),
        y_(log, "y"),
        z_(log, "z"),
        roll_(log, "roll"),
        pitch_(log, "pitch"),
        yaw_(log, "yaw"),
        velocity_(log, "velocity_body", 3),
        water_(log, "water_velocity", 3),
        wind_(log, "wind_velocity", 3),
        charge_(log, "state_of_charge"),
        task_(log, "task"),
        halt_(log, "halt") {
    if (!x_.is_there() || !y_.is_there() || !z_.is_there())
      refuse("found no positions (variables x, y and z)");
  }

  [[nodiscard]] LoggedRow row(std::size_t vehicle, std::size_t t) const {
    LoggedRow row;
    const double x = x_.at(vehicle, t), y = y_.at(vehicle, t), z = z_.at(vehicle, t);
    row.is_there = std::isfinite(x + y + z);
    if (!row.is_there) return row;
    const twin::EulerAngles turned{or_zero(roll_.at(vehicle, t)), or_zero(pitch_.at(vehicle, t)),
                                   or_zero(yaw_.at(vehicle, t))};
    const twin::Triple<double> ahead{or_zero(velocity_.at(vehicle, t, 0)),
                                     or_zero(velocity_.at(vehicle, t, 1)),
                                     or_zero(velocity_.at(vehicle, t, 2))};
    const twin::Triple<double> over_ground =
        twin::rotation_of(twin::attitude_of(turned)).to_ned(ahead);
    // The wind where no water meets it.
    const Column& stream = std::isfinite(water_.at(vehicle, t)) ? water_ : wind_;
    Pose& pose = row.pose;
    pose.east_m = narrow(x);
    pose.north_m = narrow(y);
    pose.up_m = narrow(z);
    pose.roll_rad = narrow(turned.roll_rad);
    pose.pitch_rad = narrow(turned.pitch_rad);
    pose.heading_rad = narrow(turned.yaw_rad);
    pose.east_m_s = narrow(over_ground.y);
    pose.north_m_s = narrow(over_ground.x);
    pose.up_m_s = narrow(-over_ground.z);
    pose.current_east_m_s = narrow(stream.at(vehicle, t, 0));
    pose.current_north_m_s = narrow(stream.at(vehicle, t, 1));
    pose.bed_m = narrow(constants::nan);  // the log does not have it
    pose.charge = narrow(charge_.at(vehicle, t));
    pose.vehicle = static_cast<std::uint16_t>(vehicle);
    row.halt = halt_numbered(halt_.at(vehicle, t));
    pose.is_halted = row.halt != twin::Halt::none;
    const double task = task_.at(vehicle, t);
    if (task > 0 && task < 1e9) row.task = static_cast<std::size_t>(task);
    return row;
  }

 private:
  static twin::Halt halt_numbered(double number) {
    constexpr int last = static_cast<int>(twin::Halt::no_headway);
    if (!(number > 0)) return twin::Halt::none;
    if (number <= last && number == std::floor(number)) return static_cast<twin::Halt>(number);
    refuse(formatted("found {:g} as halt, expected 0 to {}", number, last));
  }
  Column x_, y_, z_, roll_, pitch_, yaw_, velocity_, water_, wind_, charge_, task_, halt_;
};

void expect_times(const TrajectoryFile& log) {
  if (log.t_s.empty() || log.names.empty()) refuse("found no rows");
  if (log.names.size() > 0xFFFF)
    refuse(formatted("found {} vehicles, expected 65535 at most", log.names.size()));
  for (std::size_t i = 0; i < log.t_s.size(); ++i)
    if (!std::isfinite(log.t_s[i]) || (i > 0 && !(log.t_s[i] > log.t_s[i - 1])))
      refuse(formatted("found the time {:g} s in row {}, expected one after the row before it",
                       log.t_s[i], i));
}

std::optional<GeoPoint> origin_in(const TrajectoryFile& log) {
  double north_deg = 0, east_deg = 0;
  const std::string text = log.attribute("origin");
  // NOLINTNEXTLINE(cert-err34-c): both numbers are looked at
  if (std::sscanf(text.c_str(), "%lf N, %lf E", &north_deg, &east_deg) != 2) return std::nullopt;
  if (!(std::abs(north_deg) <= 90 && std::abs(east_deg) <= 360)) return std::nullopt;
  return GeoPoint::from_degrees(north_deg, east_deg);
}

/// What a log of another version holds of its scenario may be unreadable here; its rows are not.
std::optional<twin::Scenario> scenario_in(const TrajectoryFile& log,
                                          std::vector<std::string>& warnings) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty()) return std::nullopt;
  try {
    return twin::parse_scenario(yaml, "scenario");
  } catch (const Error& problem) {
    warnings.push_back("its scenario is not one of this version (" + problem.message() +
                       "): structures and tasks are left out");
    return std::nullopt;
  }
}

/// The models of vehicles, each read once.
class Models {
 public:
  Models(std::filesystem::path folder, std::vector<std::string>& warnings)
      : folder_(std::move(folder)), warnings_(warnings) {}

  std::shared_ptr<const twin::Vehicle> find(const std::string& model) {
    auto& vehicle = shelf_[model];
    if (!vehicle) vehicle = read(model);
    return vehicle;
  }

 private:
  std::shared_ptr<const twin::Vehicle> read(const std::string& model) {
    twin::Vehicle vehicle;
    vehicle.id = model;
    try {
      if (!model.empty()) vehicle = twin::read_vehicle(twin::vehicle_file(model, folder_), folder_);
    } catch (const Error& problem) {
      warnings_.push_back("without the kind and size of " + model + ": " + problem.message());
    }
    return std::make_shared<const twin::Vehicle>(std::move(vehicle));
  }

  std::filesystem::path folder_;
  std::vector<std::string>& warnings_;
  std::map<std::string, std::shared_ptr<const twin::Vehicle>> shelf_;
};

/// What the scenario says of a vehicle that was in it from the beginning.
void add_plan(const twin::ScenarioVehicle& entry, LoggedVehicle& vehicle) {
  vehicle.home_m = entry.start_m;
  vehicle.tasks = entry.tasks.size();
  if (entry.tether && entry.tether->top_m) {
    vehicle.agent.tether.emplace();
    vehicle.agent.tether->longest_m = entry.tether->length_m;
    vehicle.agent.tether_top_m = *entry.tether->top_m;
  }
  if (!entry.conduct) return;
  auto conduct = std::make_shared<twin::ReadyConduct>();
  conduct->plan = *entry.conduct;
  vehicle.home_m = conduct->home_m = entry.conduct->home_m.value_or(entry.start_m);
  vehicle.agent.conduct = std::move(conduct);
}

std::vector<std::vector<LoggedAlarm>> alarms_in(const TrajectoryFile& log) {
  std::vector<std::vector<LoggedAlarm>> alarms(log.names.size());
  const api::TableReader table(log, "alarm");
  table.for_each([&](std::size_t vehicle, std::size_t row) {
    alarms[vehicle].push_back({static_cast<std::uint32_t>(table.whole("mmsi", row)),
                               table.word("name", row), table.number("begin", row),
                               table.number("end", row)});
  });
  return alarms;
}

/// Straight ahead again once its own mission is resumed.
std::vector<LoggedCamera> cameras_of(std::size_t vehicle, std::span<const twin::Command> commands,
                                     double step_s) {
  std::vector<LoggedCamera> cameras;
  for (const twin::Command& command : commands) {
    if (command.agent != vehicle) continue;
    const double from_s = static_cast<double>(command.step) * step_s;
    if (const auto* camera = std::get_if<twin::PointCamera>(&command.what))
      cameras.push_back({from_s, camera->pointing});
    else if (std::holds_alternative<twin::Resume>(command.what) && !cameras.empty())
      cameras.push_back({from_s, {}});
  }
  return cameras;
}

void add_vehicles(const TrajectoryFile& log, const std::optional<twin::Scenario>& scenario,
                  const std::filesystem::path& data_folder, LoggedRun& run) {
  const Rows rows(log);
  // A step's time is known by the scenario alone.
  const std::vector<twin::Command> commands =
      scenario ? api::commands_in(log) : std::vector<twin::Command>();
  twin::RunAccount account;
  account.vehicles.resize(log.names.size());
  api::read_events(log, account);
  auto alarms = alarms_in(log);
  Models models(data_folder, run.warnings);
  for (std::size_t i = 0; i < log.names.size(); ++i) {
    LoggedVehicle& vehicle = run.vehicles.emplace_back();
    vehicle.agent.name = log.names[i];
    for (std::size_t t = 0; t < log.t_s.size(); ++t) vehicle.rows.push_back(rows.row(i, t));
    const auto first = std::find_if(vehicle.rows.begin(), vehicle.rows.end(),
                                    [](const LoggedRow& row) { return row.is_there; });
    if (first != vehicle.rows.end())
      vehicle.home_m = {first->pose.north_m, first->pose.east_m, -first->pose.up_m};
    std::string model;
    if (scenario && i < scenario->vehicles.size()) {
      model = scenario->vehicles[i].model;
      add_plan(scenario->vehicles[i], vehicle);
    }
    for (const twin::Command& command : commands)
      if (const auto* spawn = std::get_if<twin::Spawn>(&command.what);
          spawn != nullptr && spawn->newcomer.name == log.names[i])
        model = spawn->newcomer.model;
    vehicle.agent.vehicle = models.find(model);
    if (vehicle.agent.tether && vehicle.agent.vehicle->tether)
      vehicle.agent.tether = vehicle.agent.vehicle->tether;
    StoryOf of{i, log.names[i], {}, run.to_s()};
    if (scenario) of.rule.home_after_s = scenario->home_after_s;
    for (std::size_t t = 0; t < vehicle.rows.size() && std::isfinite(of.until_s); ++t)
      if (vehicle.rows[t].halt != twin::Halt::none) of.until_s = std::min(of.until_s, run.t_s[t]);
    vehicle.helms = helm_story(of, run.actions, commands, run.step_s);
    vehicle.cameras = cameras_of(i, commands, run.step_s);
    vehicle.stretches = twin::stretches_of(account.vehicles[i].mission, run.to_s());
    vehicle.alarms = std::move(alarms[i]);
  }
}

}  // namespace

LoggedRun read_logged_run(const std::filesystem::path& path,
                          const std::filesystem::path& data_folder) {
  const TrajectoryFile log = ingest::read_tracks_apart(path);
  return with_context(path.string(), [&] {
    expect_times(log);
    LoggedRun run;
    run.title = log.attribute("title");
    if (run.title.empty()) run.title = path.stem().string();
    run.start = log.epoch;
    run.origin = origin_in(log);
    run.t_s = log.t_s;
    const std::optional<twin::Scenario> scenario = scenario_in(log, run.warnings);
    run.actions = api::actions_in(log);
    std::stable_sort(run.actions.begin(), run.actions.end(),
                     [](const Action& a, const Action& b) { return a.time_s < b.time_s; });
    if (scenario) {
      run.step_s = scenario->step_s;
      for (const twin::ScenarioStructure& s : scenario->structures)
        run.structures.push_back(twin::shape_of(s));
    }
    add_vehicles(log, scenario, data_folder, run);
    return run;
  });
}

}  // namespace slackwater::people
