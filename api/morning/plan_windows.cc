#include "api/morning/plan_windows.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/windows/windows_answer.h"
#include "api/windows/worth.h"

namespace slackwater::api {
namespace {

using nlohmann::json;

/// What flights at the same turbine leave of the starts of a task.
void weigh(const std::vector<TaskWindows>& flown, json& task) {
  for (const TaskWindows& one : flown) {
    if (one.id != task["task"] || one.turbines != task["turbines"].get<std::vector<std::string>>())
      continue;
    for (json& start : task["starts"])
      if (const auto left = flights_leave(one, parse_utc(start["start"].get<std::string>())))
        start["worth"] = std::min(start["probability"].get<double>(), *left);
  }
}

}  // namespace

WindowsFile windows_for_plan(const PlanFile& plan, WindowsQuestion question,
                             const std::filesystem::path& store_folder,
                             const std::vector<TaskWindows>& flown) {
  std::map<std::string, std::vector<std::string>> tasks_at;
  for (const PlanFile::Work& work : plan.work)
    for (const std::size_t turbine : work.turbines) {
      std::vector<std::string>& tasks = tasks_at[plan.site.turbines[turbine].id];
      if (std::find(tasks.begin(), tasks.end(), work.task) == tasks.end())
        tasks.push_back(work.task);
    }
  question.site = plan.site_place;
  if (plan.day) {
    question.from = *plan.day;
    question.to = *plan.day + std::chrono::days(1);
  }
  question.every = std::chrono::minutes(plan.grid_min);
  question.may_leave_out = false;
  json all;
  for (const auto& [turbine, tasks] : tasks_at) {
    question.tasks = tasks;
    question.turbines = {turbine};
    json at_turbine = windows_json(question, windows_of(question, store_folder));
    for (json& task : at_turbine["tasks"]) weigh(flown, task);
    if (all.is_null())
      all = std::move(at_turbine);
    else
      for (json& task : at_turbine["tasks"]) all["tasks"].push_back(std::move(task));
  }
  return parse_windows(all.dump(), "the forecast in force");
}

}  // namespace slackwater::api
