#include "api/morning/plan_windows.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "api/windows/windows_answer.h"

namespace slackwater::api {

WindowsFile windows_for_plan(const PlanFile& plan, WindowsQuestion question,
                             const std::filesystem::path& store_folder) {
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
  nlohmann::json all;
  for (const auto& [turbine, tasks] : tasks_at) {
    question.tasks = tasks;
    question.turbines = {turbine};
    nlohmann::json at_turbine = windows_json(question, windows_of(question, store_folder));
    if (all.is_null())
      all = std::move(at_turbine);
    else
      for (nlohmann::json& task : at_turbine["tasks"]) all["tasks"].push_back(std::move(task));
  }
  return parse_windows(all.dump(), "the forecast in force");
}

}  // namespace slackwater::api
