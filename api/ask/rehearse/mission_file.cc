#include "api/ask/rehearse/mission_file.h"

#include <utility>

#include "api/ask/run/heard_traffic.h"
#include "api/program/named_sheet.h"
#include "api/program/paths.h"
#include "fields/base/config.h"
#include "fields/base/error.h"
#include "fields/geo/local_frame.h"
#include "fields/site/site.h"
#include "twin/mission/site_work.h"

namespace slackwater::api {

Config load_task(const std::string& id, const std::filesystem::path& folder) {
  return load_sheet("tasks", "tasks", id, folder);
}

std::vector<std::string> known_tasks() { return known_sheets("tasks"); }

LoadedMission lay_out_mission(const Config& mission, const std::filesystem::path& folder,
                              const std::filesystem::path& store_folder,
                              const std::vector<twin::Assumption>& assumed,
                              std::optional<bool> height_errors,
                              const twin::Intensity& thinned_by) {
  LoadedMission out;
  out.name = mission.text("name");
  const std::string named = mission.text("site");
  // A file beside the mission, or an id.
  const std::filesystem::path beside = folder / named;
  const std::string where = std::filesystem::exists(beside) ? beside.string() : named;
  const Site site = find_site(where, site_folders(store_folder));
  out.site = site.id;
  out.areas = site.areas;
  twin::MissionParts parts;
  parts.site = twin::work_site_of(site);
  parts.origin = site.point;
  parts.site_id = where;
  parts.assumed = assumed;
  parts.height_errors = height_errors;
  parts.thinned_by = thinned_by;
  parts.task = [&](const std::string& id) {
    Config task = load_task(id, folder);
    for (twin::Consequence& one : twin::read_consequences(task))
      out.consequences.push_back(std::move(one));
    return task;
  };
  out.expanded = twin::expand_mission(mission, parts);
  mission.expect_all_read();
  out.scenario = std::move(out.expanded.scenario);
  return out;
}

LoadedMission load_mission(const std::filesystem::path& file,
                           const std::filesystem::path& store_folder,
                           const std::vector<twin::Assumption>& assumed,
                           std::optional<bool> height_errors) {
  const auto folder = std::filesystem::absolute(file).parent_path();
  LoadedMission out =
      lay_out_mission(Config::load(file), folder, store_folder, assumed, height_errors);
  out.water = water_of(out.scenario, store_folder, folder);
  with_context(file.string(), [&] { add_heard_traffic(out.scenario, folder, out.water); });
  return out;
}

}  // namespace slackwater::api
