#include "api/ask/plan/plan_file.h"

#include <algorithm>

#include "api/program/named_sheet.h"
#include "api/program/paths.h"
#include "fields/base/advice.h"
#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

constexpr double m_s_per_knot = 1852.0 / 3600;

/// Reads a value by `parse`; its error names file, line and key.
template <typename Parse>
auto read(const Config& config, std::string_view key, const std::string& text, Parse parse) {
  try {
    return parse(text);
  } catch (const Error& problem) {
    config.refuse(key, problem.message());
  }
}

std::optional<Duration> read_duration(const Config& config, std::string_view key, Duration least,
                                      Duration most) {
  const auto text = config.optional_text(key);
  if (!text) return std::nullopt;
  const Duration found = read(config, key, *text, parse_duration);
  if (found < least || found > most)
    config.refuse(key, "found " + *text +
                           formatted(", expected {} min to {} h", least / std::chrono::minutes(1),
                                     most / std::chrono::hours(1)));
  return found;
}

Minute whole_minutes(Duration duration) {
  return static_cast<Minute>(std::chrono::ceil<std::chrono::minutes>(duration).count());
}

constexpr Duration a_day = std::chrono::hours(24);

twin::DayHours read_hours(const Config& config, std::string_view key) {
  const auto text = config.optional_text(key);
  if (!text) return {};
  const twin::DayHours hours = read(config, key, *text, twin::parse_day_hours);
  if (hours.to <= hours.from)
    config.refuse(key, "found " + *text + ", which goes over midnight; a plan is of one day: " +
                           "write the part that lies in it, as 20:00-24:00");
  return hours;
}

/// The thing of a list whose id a key has. @throws where there is none
template <typename Things>
std::size_t find_in(const Config& config, std::string_view key, const std::string& id,
                    const Things& things, const std::string& list) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (things[i].id == id) return i;
    known.push_back(things[i].id);
  }
  config.refuse(key, "found " + id + did_you_mean(id, known) + ", expected one of " + list + ": " +
                         (known.empty() ? "none are there" : joined(known, ", ")));
}

template <typename Things>
std::optional<std::size_t> find_if_said(const Config& config, std::string_view key,
                                        const Things& things, const std::string& list) {
  const auto id = config.optional_text(key);
  if (!id) return std::nullopt;
  return find_in(config, key, *id, things, list);
}

template <typename Things>
void expect_new(const Config& config, const Things& things, const std::string& id) {
  for (const auto& thing : things)
    if (thing.id == id) config.refuse("id", "found " + id + " twice; name each differently");
}

void read_vessels(const Config& plan, PlanFile& out) {
  for (const Config& config : plan.children("vessels")) {
    PlanFile::Vessel vessel;
    vessel.id = config.text("id");
    expect_new(config, out.vessels, vessel.id);
    vessel.crews = static_cast<std::size_t>(config.optional_integer("crews", 1, 100).value_or(1));
    vessel.speed_m_s = config.number("speed_kn", {1, 80}) * m_s_per_knot;
    vessel.hours = read_hours(config, "hours");
    if (const auto port = config.optional_child("port"))
      vessel.port = {port->optional_text("name").value_or("port"),
                     GeoPoint::from_degrees(port->number("latitude_deg", {-90, 90}),
                                            port->number("longitude_deg", {-360, 360}))};
    out.vessels.push_back(std::move(vessel));
  }
  if (out.vessels.empty()) plan.refuse("vessels", "found none, expected one at least");
}

void read_crews(const Config& plan, PlanFile& out) {
  for (const Config& config : plan.children("crews")) {
    PlanFile::Crew crew;
    crew.id = config.text("id");
    expect_new(config, out.crews, crew.id);
    crew.skills = config.texts("skills");
    crew.shift = read_hours(config, "shift");
    crew.vessel = find_if_said(config, "vessel", out.vessels, "the vessels");
    out.crews.push_back(std::move(crew));
  }
  if (out.crews.empty()) plan.refuse("crews", "found none, expected one at least");
}

void read_batteries(const Config& plan, PlanFile& out) {
  for (const Config& config : plan.children("chargers")) {
    PlanCharger charger;
    charger.id = config.text("id");
    expect_new(config, out.chargers, charger.id);
    charger.places =
        static_cast<std::size_t>(config.optional_integer("places", 1, 1000).value_or(1));
    out.chargers.push_back(std::move(charger));
  }
  for (const Config& config : plan.children("batteries")) {
    PlanBattery battery;
    battery.id = config.text("id");
    expect_new(config, out.batteries, battery.id);
    battery.count = static_cast<std::size_t>(config.integer("count", 1, 1000));
    battery.usable_wh = config.number("usable_wh", {0.1, 1e7});
    static_cast<void>(config.text("charge"));
    battery.charge_min =
        whole_minutes(*read_duration(config, "charge", std::chrono::minutes(1), a_day));
    for (const std::string& id : config.texts("chargers"))
      battery.chargers.push_back(find_in(config, "chargers", id, out.chargers, "the chargers"));
    out.batteries.push_back(std::move(battery));
  }
}

void read_vehicles(const Config& plan, PlanFile& out) {
  static const std::vector<std::string> kinds{"rov", "auv", "usv", "uav"};
  for (const Config& config : plan.children("vehicles")) {
    PlanVehicle vehicle;
    vehicle.id = config.text("id");
    expect_new(config, out.vehicles, vehicle.id);
    vehicle.kind = config.text("kind");
    if (std::find(kinds.begin(), kinds.end(), vehicle.kind) == kinds.end())
      config.refuse("kind", "found " + vehicle.kind + did_you_mean(vehicle.kind, kinds) +
                                ", expected one of " + joined(kinds, ", "));
    vehicle.vessel = find_if_said(config, "vessel", out.vessels, "the vessels");
    vehicle.battery = find_if_said(config, "battery", out.batteries, "the batteries");
    vehicle.swap_min =
        whole_minutes(read_duration(config, "swap", Duration(0), a_day).value_or(Duration(0)));
    out.vehicles.push_back(std::move(vehicle));
    // Packs and chargers are in one place.
    PlanProblem shared;
    shared.vehicles = out.vehicles;
    shared.batteries = out.batteries;
    shared.chargers = out.chargers;
    const std::vector<std::size_t> kits = kits_of(shared);
    for (std::size_t k = 0; k + 1 < out.vehicles.size(); ++k) {
      const PlanVehicle& other = out.vehicles[k];
      const PlanVehicle& last = out.vehicles.back();
      if (kits[k] == kits.back() && other.vessel && last.vessel && other.vessel != last.vessel)
        config.refuse("battery", "found packs or chargers that " + other.id + " uses on " +
                                     out.vessels[*other.vessel].id + "; those of " + last.id +
                                     " are on " + out.vessels[*last.vessel].id +
                                     ": list them apart");
    }
  }
}

/// "rov or auv": the kinds that will do.
std::vector<std::string> kinds_in(const std::string& text) {
  std::vector<std::string> kinds;
  std::size_t at = 0;
  while (true) {
    const std::size_t end = text.find(" or ", at);
    kinds.push_back(text.substr(at, end - at));
    if (end == std::string::npos) return kinds;
    at = end + 4;
  }
}

/// The vehicles that a task of the program takes, one for each of its agents but the vessel.
std::vector<std::vector<std::string>> vehicles_of_task(const Config& config,
                                                       const std::string& task) {
  const std::filesystem::path file = data_folder() / "tasks" / (task + ".yaml");
  if (task.find('/') != std::string::npos || !std::filesystem::exists(file)) {
    const std::vector<std::string> known = known_sheets("tasks");
    config.refuse("task", "found " + task + did_you_mean(task, known) + ", expected one of " +
                              joined(known, ", ") +
                              "; for a task of your own say which vehicles it takes, as vehicles: "
                              "[rov or auv], or vehicles: []");
  }
  std::vector<std::vector<std::string>> vehicles;
  for (const Config& agent : Config::load(file).children("agents")) {
    std::vector<std::string> kinds = agent.texts("kinds");
    std::erase(kinds, "vessel");
    if (!kinds.empty()) vehicles.push_back(std::move(kinds));
  }
  return vehicles;
}

void expect_vehicles(const Config& config, const PlanFile& plan, const PlanFile::Work& work) {
  for (const auto& kinds : work.vehicles) {
    const bool is_there =
        std::any_of(plan.vehicles.begin(), plan.vehicles.end(), [&](const PlanVehicle& vehicle) {
          return std::find(kinds.begin(), kinds.end(), vehicle.kind) != kinds.end();
        });
    if (!is_there)
      config.refuse("task", "found no vehicle that could do " + work.task + ": it takes a " +
                                joined(kinds, " or ") + "; list one under vehicles");
  }
}

void expect_crew(const Config& config, const PlanFile& plan, const PlanFile::Work& work) {
  std::vector<std::string> known;
  for (const PlanFile::Crew& crew : plan.crews)
    known.insert(known.end(), crew.skills.begin(), crew.skills.end());
  for (const std::string& skill : work.skills)
    if (std::find(known.begin(), known.end(), skill) == known.end())
      config.refuse("skills", "found " + skill + did_you_mean(skill, known) +
                                  ", which no crew has; list it with a crew's skills");
  const bool is_there =
      std::any_of(plan.crews.begin(), plan.crews.end(), [&](const PlanFile::Crew& crew) {
        return std::all_of(work.skills.begin(), work.skills.end(), [&](const std::string& skill) {
          return std::find(crew.skills.begin(), crew.skills.end(), skill) != crew.skills.end();
        });
      });
  if (!is_there)
    config.refuse("skills", "found no single crew that has all of " + joined(work.skills, ", ") +
                                ", which " + work.task + " takes");
}

void read_work(const Config& plan, PlanFile& out) {
  for (const Config& config : plan.children("tasks")) {
    PlanFile::Work work;
    work.task = config.text("task");
    static_cast<void>(config.has("turbines"));
    for (const std::string& id : config.texts("turbines")) {
      const std::size_t turbine =
          find_in(config, "turbines", id, out.site.turbines, "the turbines of " + out.site.id);
      for (const PlanFile::Work& other : out.work)
        if (other.task == work.task && std::find(other.turbines.begin(), other.turbines.end(),
                                                 turbine) != other.turbines.end())
          config.refuse("turbines", "found " + work.task + " at " + id + " twice; keep one");
      if (std::find(work.turbines.begin(), work.turbines.end(), turbine) != work.turbines.end())
        config.refuse("turbines", "found " + id + " twice; keep one");
      work.turbines.push_back(turbine);
    }
    if (work.turbines.empty())
      config.refuse("turbines", "found none, expected one at least, as turbines: [A01]");
    work.priority = config.optional_number("priority", {0.001, 1e6}).value_or(1);
    if (config.has("vehicles") || config.is_list("vehicles")) {
      for (const std::string& text : config.texts("vehicles"))
        work.vehicles.push_back(kinds_in(text));
    } else {
      work.vehicles = vehicles_of_task(config, work.task);
    }
    work.skills = config.texts("skills");
    work.duration = read_duration(config, "duration", std::chrono::minutes(1), 31 * a_day);
    work.contingency = read_duration(config, "contingency", Duration(0), 31 * a_day);
    work.drop_off = read_duration(config, "drop_off", std::chrono::minutes(1), a_day);
    work.energy_wh = config.optional_number("energy_wh", {0, 1e7});
    if (const auto light = config.optional_text("daylight"))
      work.light = read(config, "daylight", *light, twin::parse_light);
    expect_vehicles(config, out, work);
    expect_crew(config, out, work);
    out.work.push_back(std::move(work));
  }
  if (out.work.empty()) plan.refuse("tasks", "found none, expected one at least");
}

}  // namespace

PlanFile load_plan_file(const std::filesystem::path& file,
                        const std::filesystem::path& store_folder) {
  const Config config = Config::load(file);
  PlanFile plan;
  plan.name = config.optional_text("name").value_or(file.stem().string());
  const std::string named = config.text("site");
  const std::filesystem::path beside = file.parent_path() / named;
  plan.site_place = std::filesystem::is_regular_file(beside) ? beside.string() : named;
  plan.site = find_site(plan.site_place, site_folders(store_folder));
  if (const auto day = config.optional_text("day"))
    plan.day = read(config, "day", *day, [](const std::string& text) { return parse_day(text); });
  if (const auto grid =
          read_duration(config, "grid", std::chrono::minutes(5), std::chrono::hours(2))) {
    plan.grid_min = static_cast<Minute>(*grid / std::chrono::minutes(1));
    if (*grid % std::chrono::minutes(1) != Duration(0) || 24 * 60 % plan.grid_min != 0)
      config.refuse("grid", "found " + config.text("grid") +
                                ", which does not divide a day; expected e.g. 15min or 30min");
  }
  read_vessels(config, plan);
  read_crews(config, plan);
  read_batteries(config, plan);
  read_vehicles(config, plan);
  read_work(config, plan);
  config.expect_all_read();
  return plan;
}

}  // namespace slackwater::api
