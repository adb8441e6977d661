#include "api/rehearse/run_outcome.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "api/rehearse/cleaning_report.h"
#include "api/rehearse/closest.h"
#include "api/rehearse/fate.h"
#include "api/rehearse/inspection_report.h"
#include "api/rehearse/mission_events.h"
#include "api/rehearse/vehicle_log.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using ingest::TrajectoryFile;
using twin::ScenarioStructure;

constexpr double degrees = 57.29577951308232;

std::string clock_text(const TrajectoryFile& log, double t_s) {
  constexpr std::size_t time_of_day = 11;  // behind 2025-06-01T
  const auto whole = Duration(static_cast<Duration::rep>(std::floor(t_s)) * 1000);
  return format_utc(log.epoch + whole).substr(time_of_day, 8) + " UTC";
}

using Margins = std::vector<std::pair<std::string, std::string>>;

void add_energy(const VehicleLog& vehicle, Margins& margins) {
  const double delivered = vehicle.last("energy_delivered");
  const double drawn = vehicle.last("electrical_energy");
  const double used = std::isfinite(drawn) ? drawn : delivered;
  if (delivered > 0)
    margins.emplace_back("Battery left",
                         formatted("{:.1f} %", 100 * vehicle.last("state_of_charge")));
  if (used > 0) margins.emplace_back("Energy used", formatted("{:.1f} Wh", used / 3600));
  if (delivered > 0) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t t = 0; t < vehicle.rows(); ++t)
      least = std::min(least, vehicle.at("bus_voltage", t));
    if (std::isfinite(least)) margins.emplace_back("Least voltage", formatted("{:.1f} V", least));
  }
  if (const double fuel = vehicle.last("fuel_burnt"); fuel > 0)
    margins.emplace_back("Fuel burnt", formatted("{:.2f} kg", fuel));
}

void add_largest(const TrajectoryFile& log, const VehicleLog& vehicle, Margins& margins) {
  const auto add = [&](const char* what, const char* variable, double scale, const char* unit) {
    const auto largest = vehicle.largest(variable);
    if (!largest || largest->value == 0) return;
    const double size = scale * std::abs(largest->value);
    margins.emplace_back(what, (size < 10 ? formatted("{:.2f}", size) : formatted("{:.0f}", size)) +
                                   unit + " at " + clock_text(log, largest->t_s));
  };
  add("Farthest off the track", "across_track", 1, " m");
  add("Farthest off the depth", "below_track", 1, " m");
  add("Largest roll", "roll", degrees, "°");
  add("Largest pitch", "pitch", degrees, "°");
  add("Largest pull of the tether", "tether_tension", 1, " N");
}

void add_approach(const TrajectoryFile& log, const char* what,
                  const std::optional<Approach>& approach, Margins& margins) {
  if (!approach) return;
  const std::string who = approach->to.empty() ? std::to_string(approach->mmsi) : approach->to;
  margins.emplace_back(what, formatted("{:.1f} m, {} at {}", std::max(0.0, approach->distance_m),
                                       who, clock_text(log, approach->t_s)));
}

void add_closest(const TrajectoryFile& log, const Closest& closest, Margins& margins) {
  add_approach(log, "Closest to a structure", closest.structure, margins);
  add_approach(log, "Closest to another vehicle", closest.vehicle, margins);
  add_approach(log, "Closest to a vessel", closest.vessel, margins);
  add_approach(log, "Closest to another's tether", closest.tether, margins);
}

const twin::ScenarioVehicle* entry_of(const twin::Scenario* scenario, const std::string& name) {
  if (scenario == nullptr) return nullptr;
  for (const twin::ScenarioVehicle& vehicle : scenario->vehicles)
    if (vehicle.name == name) return &vehicle;
  return nullptr;
}

std::string tasks_text(std::size_t begun, std::size_t all) {
  const std::size_t done = std::min(begun, all);
  return std::to_string(done) + " of " + std::to_string(all) + (all == 1 ? " task" : " tasks") +
         " done";
}

/// Events of the row at which a counted variable changes.
template <typename Tell>
void on_change(const TrajectoryFile& log, const char* name, std::size_t vehicle, const Tell& tell) {
  const TrajectoryFile::Variable* variable = log.find(name);
  if (variable == nullptr) return;
  const std::size_t times = log.t_s.size();
  for (std::size_t t = 0; t < times; ++t) {
    const double now = variable->values[(vehicle * times + t) * variable->per];
    const double last = t == 0 ? 0 : variable->values[(vehicle * times + t - 1) * variable->per];
    const double before = std::isfinite(last) ? last : 0;  // of one that has just joined
    if (now != before && std::isfinite(now)) tell(log.t_s[t], static_cast<int>(now), *variable);
  }
}

void add_alarms(const TrajectoryFile& log, std::vector<RunEvent>& events) {
  const ingest::TrajectoryTable* alarms = log.find_table("alarm");
  if (alarms == nullptr) return;
  const std::vector<double>* vehicle = alarms->column("vehicle");
  const std::vector<double>* begin = alarms->column("begin");
  const std::vector<std::string>* name = alarms->text("name");
  if (vehicle == nullptr || begin == nullptr) return;
  for (std::size_t i = 0; i < alarms->rows(); ++i) {
    const double index = (*vehicle)[i];
    if (!(index >= 0 && index < static_cast<double>(log.names.size()))) continue;
    const std::string who = name != nullptr && i < name->size() ? (*name)[i] : "";
    events.push_back(
        {(*begin)[i], static_cast<std::size_t>(index), "alarm" + (who.empty() ? "" : ": " + who)});
  }
}

}  // namespace

std::optional<twin::Scenario> scenario_of(const TrajectoryFile& log) {
  const std::string yaml = log.attribute("scenario");
  if (yaml.empty()) return std::nullopt;
  try {
    return twin::parse_scenario(yaml, "scenario of the log");
  } catch (const Error&) {  // of another version: the page does without
    return std::nullopt;
  }
}

std::string halt_in_words(const TrajectoryFile::Variable& halt, int number) {
  static const std::map<std::string, std::string> words{
      {"diverged", "stopped: the calculation diverged"},
      {"outside_area", "left the area of the forecast"},
      {"outside_time", "came to the end of the forecast"},
      {"aground", "ran aground"},
      {"no_data", "came where the forecast has no data"},
      {"struck", "struck something"},
      {"capsized", "capsized"},
      {"no_headway", "made no headway"}};
  std::istringstream names(halt.long_name);
  for (std::string entry; std::getline(names, entry, ',');) {
    std::istringstream parts(entry);
    int code = 0;
    std::string name;
    if (!(parts >> code >> name) || code != number) continue;
    const auto known = words.find(name);
    return known == words.end() ? "stopped: " + name : known->second;
  }
  return "stopped";
}

std::vector<RunEvent> events_of(const TrajectoryFile& log, const twin::Scenario* scenario) {
  std::vector<RunEvent> events;
  std::set<std::size_t> with_mission;
  for (const MissionEvent& event : mission_events_in(log)) {
    with_mission.insert(event.vehicle);
    events.push_back({event.t_s, event.vehicle, event.text});
  }
  for (std::size_t i = 0; i < log.names.size(); ++i) {
    const twin::ScenarioVehicle* entry = entry_of(scenario, log.names[i]);
    // Its phases say more than the numbers of its tasks.
    if (!with_mission.contains(i))
      on_change(log, "task", i, [&](double t_s, int task, const auto&) {
        const bool is_last =
            entry != nullptr && static_cast<std::size_t>(task) >= entry->tasks.size();
        events.push_back(
            {t_s, i, is_last ? "all tasks done" : "task " + std::to_string(task + 1) + " begins"});
      });
    if (const std::size_t first = VehicleLog(log, i).first(); first > 0)
      events.push_back({log.t_s[first], i, "joins the run"});
    on_change(log, "battery_off", i, [&](double t_s, int off, const auto&) {
      events.push_back({t_s, i, off != 0 ? "battery cut off" : "battery on again"});
    });
    on_change(log, "halt", i, [&](double t_s, int halt, const auto& variable) {
      if (halt != 0) events.push_back({t_s, i, halt_in_words(variable, halt)});
    });
  }
  add_alarms(log, events);
  std::stable_sort(events.begin(), events.end(),
                   [](const RunEvent& a, const RunEvent& b) { return a.t_s < b.t_s; });
  return events;
}

std::vector<VehicleOutcome> outcomes_of(const TrajectoryFile& log, const twin::Scenario* scenario) {
  std::vector<VehicleLog> vehicles;
  for (std::size_t i = 0; i < log.names.size(); ++i) vehicles.emplace_back(log, i);
  std::vector<VehicleOutcome> outcomes;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    const VehicleLog& vehicle = vehicles[i];
    VehicleOutcome outcome;
    outcome.name = log.names[i];
    const double halt = vehicle.last("halt");
    outcome.is_stopped = halt > 0;
    const std::string befell = fate_in(log, i);
    std::string verdict = !befell.empty() ? befell
                          : outcome.is_stopped
                              ? halt_in_words(*log.find("halt"), static_cast<int>(halt)) + " at " +
                                    clock_text(log, log.t_s[vehicle.rows() - 1])
                              : std::string("ran to the end");
    verdict[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(verdict[0])));
    const twin::ScenarioVehicle* entry = entry_of(scenario, outcome.name);
    const double task = vehicle.last("task");
    if (entry != nullptr && !entry->tasks.empty() && task >= 0)
      verdict += "; " + tasks_text(static_cast<std::size_t>(task), entry->tasks.size());
    outcome.verdict = verdict + ".";
    add_energy(vehicle, outcome.margins);
    if (std::string cleaned = cleaned_in(log, i); !cleaned.empty())
      outcome.margins.emplace_back("Cleaned", std::move(cleaned));
    if (std::string seen = inspected_in(log, i); !seen.empty())
      outcome.margins.emplace_back("Inspected", std::move(seen));
    add_closest(log, closest_in(log, vehicles, i, scenario), outcome.margins);
    if (const auto alarms = clearance_alarms_in(log, i))
      outcome.margins.emplace_back("Clearance alarms", *alarms);
    add_largest(log, vehicle, outcome.margins);
    outcomes.push_back(std::move(outcome));
  }
  return outcomes;
}

}  // namespace slackwater::api
