#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "api/ask/plan/plan_problem.h"
#include "fields/site/site.h"
#include "twin/risk/workability/calendar.h"
#include "twin/risk/workability/daylight.h"

namespace slackwater::api {

/// What is to be done, and what there is to do it with, as a plan's YAML has it:
///
///     name: Anodes and blades
///     site: example_farm                      # an id, or a file beside this one
///     day: 2025-06-02                         # absent: that of the windows
///     grid: 15min
///     vessels:
///       - {id: ctv1, crews: 2, speed_kn: 20, hours: 06:00-18:00,
///          port: {name: Saint-Malo, latitude_deg: 48.64, longitude_deg: -2.03}}
///     crews:
///       - {id: blue, skills: [rov], shift: 06:00-18:00, vessel: ctv1}
///     vehicles:
///       - {id: rov1, kind: rov, vessel: ctv1, battery: rov_pack, swap: 15min}
///     batteries:
///       - {id: rov_pack, count: 3, usable_wh: 220, charge: 2h, chargers: [deck]}
///     chargers:
///       - {id: deck, places: 1}
///     tasks:
///       - {task: cp_anode, turbines: [A01, A02], priority: 3, skills: [rov]}
///       - {task: scour_survey, turbines: [B01], vehicles: [rov or auv], duration: 90min,
///          contingency: 30min, drop_off: 15min, energy_wh: 150, daylight: civil}
///
/// Hours are of the site's clocks. What a task takes is that of data/tasks where `vehicles` does
/// not say; how long it takes and how likely it is done, the windows say.
struct PlanFile {
  struct Port {
    std::string name;
    GeoPoint point;
  };
  struct Vessel {
    std::string id;
    std::size_t crews = 1;
    double speed_m_s = 10;
    twin::DayHours hours;
    std::optional<Port> port;
  };
  struct Crew {
    std::string id;
    std::vector<std::string> skills;
    twin::DayHours shift;
    std::optional<std::size_t> vessel;
  };
  struct Work {
    std::string task;
    std::vector<std::size_t> turbines;  ///< of the site
    double priority = 1;
    std::vector<std::vector<std::string>> vehicles;
    std::vector<std::string> skills;
    std::optional<Duration> duration;  ///< in place of that of the windows
    std::optional<Duration> contingency;
    std::optional<Duration> drop_off;  ///< absent: the vessel stays
    std::optional<double> energy_wh;
    std::optional<twin::Light> light;  ///< it begins and ends in it
  };
  std::string name;
  Site site;
  std::string site_place;  ///< its id, or the path of its file
  std::optional<UtcDay> day;
  Minute grid_min = 15;
  std::vector<Vessel> vessels;
  std::vector<Crew> crews;
  std::vector<PlanVehicle> vehicles;
  std::vector<PlanBattery> batteries;
  std::vector<PlanCharger> chargers;
  std::vector<Work> work;
};

/// @throws Error(invalid_input) with file, line and key; Error(not_found) for a site or a file that
///         is not there
[[nodiscard]] PlanFile load_plan_file(const std::filesystem::path& file,
                                      const std::filesystem::path& store_folder);

}  // namespace slackwater::api
