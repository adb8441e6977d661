#include "api/morning/morning.h"

#include <algorithm>
#include <array>

#include "api/morning/morning_clock.h"
#include "api/morning/plan_windows.h"
#include "api/plan/make_plan.h"
#include "api/plan/plan_setup.h"
#include "fields/base/attempt.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

void add_plan(const PlanFile& file, const std::filesystem::path& store_folder, Morning& morning) {
  const auto failure = attempt([&] {
    WindowsQuestion question = morning.question.windows;
    question.from = morning.windows.from;
    question.to = morning.windows.to;
    const WindowsFile windows = windows_for_plan(file, question, store_folder);
    MorningPlan made;
    made.problem = problem_of(file, windows, 0);
    made.answer.name = file.name;
    made.answer.site = file.site.id;
    made.answer.time_limit_s = morning.question.plan_limit_s;
    made.answer.plan = make_plan(made.problem, morning.question.plan_limit_s);
    morning.plan = std::move(made);
  });
  if (failure) morning.no_plan = failure->why;
}

}  // namespace

Morning morning_of(const MorningQuestion& question, const std::filesystem::path& store_folder) {
  Morning morning;
  morning.question = question;
  std::optional<PlanFile> plan;  // what is misspelt is said before anything is worked out
  if (!question.plan.empty()) plan = load_plan_file(question.plan, store_folder);
  morning.windows = windows_of(question.windows, store_folder);
  if (plan) add_plan(*plan, store_folder, morning);
  return morning;
}

std::filesystem::path plan_of_site(const std::string& site_id,
                                   const std::filesystem::path& store_folder) {
  const std::filesystem::path file = store_folder / "plans" / (site_id + ".yaml");
  std::error_code unreadable;
  return std::filesystem::is_regular_file(file, unreadable) ? file : std::filesystem::path();
}

std::size_t futures_of(const Morning& morning) {
  if (morning.question.windows.members > 0) return morning.question.windows.members;
  return morning.windows.water.surround.field->snapshot().members;
}

std::vector<const TaskWindows*> by_verdict(const Morning& morning) {
  std::vector<const TaskWindows*> tasks;
  for (const TaskWindows& task : morning.windows.tasks) tasks.push_back(&task);
  std::stable_sort(tasks.begin(), tasks.end(), [](const TaskWindows* a, const TaskWindows* b) {
    return a->verdict < b->verdict;
  });
  return tasks;
}

std::string headline_of(const Morning& morning) {
  std::array<std::size_t, 3> counts{};
  for (const TaskWindows& task : morning.windows.tasks)
    ++counts.at(static_cast<std::size_t>(task.verdict));
  const std::size_t all = morning.windows.tasks.size();
  const std::string when = " " + MorningClock(morning).span();
  if (counts[0] == all)
    return (all == 1 ? std::string("Go for the task") : formatted("Go for all {} tasks", all)) +
           when + ".";
  std::string text = counts[0] > 0 ? formatted("Go for {} of {} tasks", counts[0], all) + when
                                   : formatted("No task is a go of {}", all) + when;
  std::vector<std::string> others;
  if (counts[1] > 0) others.push_back(formatted("{} marginal", counts[1]));
  if (counts[2] > 0) others.push_back(formatted("{} no-go", counts[2]));
  return text + "; " + joined(others, ", ") + ".";
}

}  // namespace slackwater::api
