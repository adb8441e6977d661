#include "api/ask/morning/plan_windows.h"

#include <algorithm>
#include <map>

#include "api/ask/windows/as_told.h"
#include "api/ask/windows/worth.h"

namespace slackwater::api {
namespace {

/// The plan's tasks by turbine, each once.
std::map<std::string, std::vector<std::string>> tasks_by_turbine(const PlanFile& plan) {
  std::map<std::string, std::vector<std::string>> tasks_at;
  for (const PlanFile::Work& work : plan.work)
    for (const std::size_t turbine : work.turbines) {
      std::vector<std::string>& tasks = tasks_at[plan.site.turbines[turbine].id];
      if (std::find(tasks.begin(), tasks.end(), work.task) == tasks.end())
        tasks.push_back(work.task);
    }
  return tasks_at;
}

/// What flights at the same turbine leave of the starts of a task.
void weigh(const std::vector<TaskWindows>& flown, const TaskWindows& task,
           DayChances::Task& chances) {
  for (const TaskWindows& one : flown) {
    if (one.id != task.id || one.turbines != task.turbines) continue;
    for (std::size_t i = 0; i < chances.starts.size(); ++i)
      if (const auto left = flights_leave(one, chances.starts[i].time))
        chances.starts[i].probability = std::min(chances.starts[i].probability, *left);
  }
}

}  // namespace

DayChances::Task chances_of(const TaskWindows& task) {
  DayChances::Task chances;
  chances.task = task.id;
  if (task.turbines.size() == 1) chances.turbine = task.turbines.front();
  chances.contingency = duration_of_hours(as_told(task.contingency_s / 3600));
  const Duration duration = duration_of_hours(as_told(task.planned_s / 3600));
  for (const TaskStart& start : task.starts)
    chances.starts.push_back({start.start, as_told(start.worth), duration, 0});
  return chances;
}

DayChances windows_for_plan(const PlanFile& plan, WindowsQuestion question,
                            const std::filesystem::path& store_folder,
                            const std::vector<TaskWindows>& flown) {
  question.site = plan.site_place;
  if (plan.day) {
    question.from = *plan.day;
    question.to = *plan.day + std::chrono::days(1);
  }
  question.every = std::chrono::minutes(plan.grid_min);
  question.may_leave_out = question.may_leave_all_out = true;
  DayChances all;
  all.name = "the forecast in force";
  for (const auto& [turbine, tasks] : tasks_by_turbine(plan)) {
    question.tasks = tasks;
    question.turbines = {turbine};
    WindowsAnswer answer = windows_of(question, store_folder);
    all.site = answer.site_id;
    all.day = day_of(answer.from);
    for (const TaskWindows& task : answer.tasks) {
      all.tasks.push_back(chances_of(task));
      weigh(flown, task, all.tasks.back());
    }
    for (const TaskLeftOut& one : answer.left_out) {
      all.tasks.push_back({one.task, turbine, Duration(0), {}, one.why});
    }
    question.water = std::move(answer.water);
    question.past = std::move(answer.past);
  }
  return all;
}

}  // namespace slackwater::api
