#include "api/ask/windows/task_sheet.h"

#include <algorithm>
#include <set>

#include "fields/base/error.h"
#include "twin/mission/cable_of_site.h"

namespace slackwater::api {
namespace {

double length_m(const twin::WorkCable& cable) {
  double sum_m = 0;
  for (std::size_t i = 1; i < cable.route_m.size(); ++i)
    sum_m += twin::length_of(cable.route_m[i] - cable.route_m[i - 1]);
  return sum_m;
}

/// Of the cables that the work of any agent follows at any of the turbines, each once.
double cable_km(const Config& task, const twin::WorkSite& site,
                std::span<const std::string> turbines) {
  std::set<const twin::WorkCable*> followed;
  for (const Config& agent : task.children("agents"))
    for (const Config& work : agent.children("work")) {
      if (!twin::names_cable(work)) continue;
      for (const twin::WorkTurbine& turbine : site.turbines)
        if (std::find(turbines.begin(), turbines.end(), turbine.id) != turbines.end())
          followed.insert(&twin::cable_of_site(work, site, turbine));
    }
  double sum_m = 0;
  for (const twin::WorkCable& cable : site.cables)
    if (followed.contains(&cable)) sum_m += length_m(cable);
  return sum_m / 1000;
}

}  // namespace

std::optional<double> TaskSheet::planned_h(std::size_t turbines) const {
  if (!duration_h) return std::nullopt;
  if (per == "km") return *duration_h * cable_km;
  return *duration_h * static_cast<double>(turbines);
}

double TaskSheet::contingency_h() const {
  if (!min_window_h || !duration_h) return 0;
  return std::max(0.0, *min_window_h - (per == "km" ? *duration_h * cable_km : *duration_h));
}

TaskSheet read_task_sheet(const Config& task, const twin::WorkSite& site,
                          std::span<const std::string> turbines) {
  TaskSheet sheet;
  sheet.name = task.text("name");
  if (const auto duration = task.optional_child("duration_h")) {
    sheet.duration_h = duration->number("value", {0.01, 1000});
    sheet.per = duration->optional_text("per").value_or("");
  }
  sheet.min_window_h = task.optional_number("min_window_h", {0.01, 2000});
  if (const auto light = task.optional_text("daylight")) {
    try {
      sheet.daylight = twin::parse_light(*light);
    } catch (const Error& problem) {
      task.refuse("daylight", problem.message());
    }
  }
  sheet.is_splittable = task.optional_flag("splittable").value_or(false);
  const auto least_visit_h = task.optional_number("least_visit_h", {0.1, 24});
  if (least_visit_h && !sheet.is_splittable)
    task.refuse("least_visit_h", "found without splittable: true; say both, or neither");
  sheet.least_visit_h = least_visit_h.value_or(0);
  sheet.cable_km = cable_km(task, site, turbines);
  return sheet;
}

}  // namespace slackwater::api
