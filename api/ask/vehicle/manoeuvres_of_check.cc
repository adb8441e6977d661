#include "api/ask/vehicle/manoeuvres_of_check.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "api/ask/run/scenario_run.h"
#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/base/text.h"
#include "twin/state/manoeuvre_plan.h"
#include "twin/vehicle/own_autopilot.h"

namespace slackwater::api {
namespace {

using constants::degree;
using twin::ManoeuvreKind;
using twin::ManoeuvreTask;
using twin::Vehicle;

constexpr double ships_rudder_deg = 35;
constexpr double water_depth_m = 100;

/// A manoeuvre to be flown; without a task, why it is none.
struct Wanted {
  std::string name;
  std::optional<ManoeuvreTask> task;
  std::string why_not;
};

/// Time for the slowest of its loops to settle.
double settling_s(const Vehicle& vehicle) {
  const twin::AutopilotSettings& s = vehicle.autopilot;
  return std::clamp(4 * std::max({s.heading_period_s, s.vertical_period_s, s.horizontal_period_s}),
                    60.0, 600.0);
}

/// What a run would say against it; nothing: it can be flown.
std::string refusal_of(const ManoeuvreTask& task, const Vehicle& vehicle,
                       const twin::Autopilot& autopilot) {
  try {
    (void)twin::plan_manoeuvre(task, vehicle, autopilot, vehicle.cruise_speed_m_s,
                               twin::usual_voltage_v(vehicle));
  } catch (const Error& problem) {
    return problem.message();
  }
  return "";
}

ManoeuvreTask begun_at_cruise(const Vehicle& vehicle, ManoeuvreKind kind) {
  ManoeuvreTask task;
  task.kind = kind;
  task.approach_s = settling_s(vehicle);
  return task;
}

/// All the helm that there is: of a craft without a rudder the largest share that leaves the thrust
/// of its speed.
Wanted circle(const Vehicle& vehicle, const twin::Autopilot& autopilot) {
  ManoeuvreTask task = begun_at_cruise(vehicle, ManoeuvreKind::turning_circle);
  task.heading_change_rad = 540 * degree;
  task.lasts_s = 1800;
  Wanted wanted{"turning circle", std::nullopt, ""};
  if (vehicle.rudder.area_m2 > 0) {
    wanted.why_not = refusal_of(task, vehicle, autopilot);
    if (wanted.why_not.empty()) wanted.task = task;
    return wanted;
  }
  task.helms_are_shares = true;
  for (const double share : {1.0, 0.7, 0.5, 0.35, 0.2, 0.1, 0.05}) {
    task.helms = {share};
    wanted.why_not = refusal_of(task, vehicle, autopilot);
    if (!wanted.why_not.empty()) continue;
    wanted.task = task;
    break;
  }
  return wanted;
}

/// By as many degrees of rudder as of heading, or all that it has.
Wanted zig_zag(const Vehicle& vehicle, const twin::Autopilot& autopilot, double psi_deg) {
  ManoeuvreTask task = begun_at_cruise(vehicle, ManoeuvreKind::zig_zag);
  task.heading_change_rad = psi_deg * degree;
  task.executes = 5;
  task.lasts_s = 1200;
  if (vehicle.rudder.area_m2 > 0) {
    task.helms = {std::min(psi_deg * degree, vehicle.rudder.limit_rad)};
  } else {
    task.helms_are_shares = true;
    task.helms = {psi_deg / ships_rudder_deg};
  }
  Wanted wanted{formatted("zig-zag {:g}/{:g}", psi_deg, psi_deg), std::nullopt,
                refusal_of(task, vehicle, autopilot)};
  if (wanted.why_not.empty()) wanted.task = task;
  return wanted;
}

/// 30 degrees to starboard, down by 2 m where it swims, then slower and up to its cruise speed.
Wanted steps(const Vehicle& vehicle, const twin::Autopilot& autopilot, double depth_m) {
  ManoeuvreTask task = begun_at_cruise(vehicle, ManoeuvreKind::steps);
  const double cruise_m_s = vehicle.cruise_speed_m_s;
  const double each_s = settling_s(vehicle);
  const auto next = [&]() -> twin::KeptStep& {
    twin::KeptStep& step = task.steps.emplace_back();
    step.at_s = each_s * static_cast<double>(task.steps.size());
    return step;
  };
  task.speed_m_s = cruise_m_s;
  next().heading_rad = 30 * degree;
  if (vehicle.body.hull.strips == 0) next().depth_m = depth_m + 2;
  next().speed_m_s = std::max(0.6 * cruise_m_s, vehicle.autopilot.least_speed_m_s);
  next().speed_m_s = cruise_m_s;
  task.lasts_s = each_s * static_cast<double>(task.steps.size() + 1);
  Wanted wanted{"steps", std::nullopt, refusal_of(task, vehicle, autopilot)};
  if (wanted.why_not.empty()) wanted.task = task;
  return wanted;
}

/// In the open, heading north: far from the others, and from the bed.
twin::ScenarioVehicle entry_of(const Wanted& wanted, std::size_t number, double depth_m,
                               const std::filesystem::path& file) {
  constexpr double apart_m = 5000;
  twin::ScenarioVehicle entry;
  entry.name = wanted.name;
  entry.model = file.string();
  entry.start_m = {0, apart_m * static_cast<double>(number), depth_m};
  twin::ScenarioTask task;
  task.kind = twin::ScenarioTask::Kind::manoeuvre;
  task.manoeuvre = wanted.task;
  task.hold_s = twin::longest_s(*wanted.task);
  entry.tasks = {task};
  return entry;
}

/// The way of a vehicle of a run.
std::vector<twin::ManoeuvreRow> way_of(const twin::RunLog& log, std::size_t vehicle) {
  std::map<std::string, std::vector<double>, std::less<>> columns;
  return twin::manoeuvre_rows(
      {log.t_s, [&](std::string_view name) -> std::span<const double> {
         auto found = columns.find(name);
         if (found == columns.end())
           found = columns.emplace(std::string(name), log.column(vehicle, name)).first;
         return found->second;
       }});
}

}  // namespace

std::vector<FlownManoeuvre> manoeuvres_of_check(const Vehicle& vehicle,
                                                const twin::Autopilot& autopilot,
                                                const std::filesystem::path& file) {
  const bool floats = vehicle.body.hull.strips > 0;
  const double depth_m =
      floats ? 0 : std::min(20.0, 0.5 * vehicle.rated_depth_m.value_or(water_depth_m));
  const std::array wanted{circle(vehicle, autopilot), zig_zag(vehicle, autopilot, 10),
                          zig_zag(vehicle, autopilot, 20), steps(vehicle, autopilot, depth_m)};
  twin::Scenario scenario;
  scenario.name = "check of " + vehicle.id;
  scenario.step_s = std::max(0.1, vehicle.largest_step_s);
  scenario.log_every_s = scenario.step_s;
  twin::MadeUpWater water;
  water.depth_m = water_depth_m;
  scenario.water = water;
  scenario.waves.from_forecast = false;
  scenario.origin = GeoPoint::from_degrees(55, 0);
  scenario.has_origin = true;
  for (const Wanted& one : wanted) {
    if (!one.task) continue;
    scenario.duration_s = std::max(scenario.duration_s, twin::longest_s(*one.task) + 1);
    scenario.vehicles.push_back(entry_of(one, scenario.vehicles.size(), depth_m, file));
  }
  std::vector<FlownManoeuvre> flown;
  const ScenarioResult result =
      scenario.vehicles.empty() ? ScenarioResult{}
                                : run_scenario(scenario, water_of(scenario, {}, {}), RunChoice{});
  std::size_t next = 0;
  for (const Wanted& one : wanted) {
    FlownManoeuvre out{one.name, std::nullopt, one.why_not, {}};
    if (one.task) {
      out.rows = way_of(result.log, next);
      const twin::VehicleAccount& account = result.account.vehicles[next++];
      if (!account.manoeuvres.empty()) out.account = account.manoeuvres.front();
      if (account.halt != twin::Halt::none) out.why_not = account.fate_text(result.account.start);
    }
    flown.push_back(std::move(out));
  }
  return flown;
}

}  // namespace slackwater::api
