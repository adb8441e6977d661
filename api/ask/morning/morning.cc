#include "api/ask/morning/morning.h"

#include <algorithm>

#include "api/ask/morning/plan_windows.h"
#include "api/ask/plan/make_plan.h"
#include "api/ask/plan/plan_setup.h"
#include "fields/base/attempt.h"
#include "fields/base/error.h"

namespace slackwater::api {
namespace {

/// A plan is of the day that its file names, or else of the morning's.
void expect_of_the_day(const PlanFile& file, const Morning& morning) {
  const UtcDay day = day_of(morning.windows.from);
  if (file.day && *file.day != day)
    throw Error(ErrorKind::invalid_input, "found a plan of " + format_day(*file.day) +
                                              ", expected one of " + format_day(day) +
                                              "; change its day, or leave it out");
}

/// From the next start of the grid until midnight, on the day of the issue, and on the day that is
/// told beside it where nothing newer was issued since. Why there are none is noted there.
std::optional<WindowsAnswer> hours_left_today(const MorningQuestion& asked, WindowsAnswer& next_day,
                                              const std::filesystem::path& store_folder) {
  const WindowsQuestion& question = asked.windows;
  if (question.from || question.to) return std::nullopt;
  const Snapshot& forecast = next_day.water.surround.field->snapshot();
  const UtcTime now = std::max(forecast.issued, asked.now.value_or(forecast.issued));
  const UtcTime midnight(day_of(now));
  const bool is_day_of_issue = day_of(now) == day_of(forecast.issued);
  WindowsQuestion today = question;
  today.from = midnight +
               question.every * ((now - midnight + question.every - Duration(1)) / question.every);
  today.to = midnight + std::chrono::days(1);
  if (*today.from >= *today.to) return std::nullopt;
  if (is_day_of_issue ? *today.to != next_day.from
                      : midnight != next_day.from || *today.from == next_day.from)
    return std::nullopt;
  today.water = next_day.water;
  today.past = next_day.past;
  std::optional<WindowsAnswer> answer;
  if (const auto failure = attempt([&] { answer = windows_of(today, store_folder); }))
    next_day.notes.push_back("the hours left today could not be worked out: " + failure->why);
  return answer;
}

void add_decisions(Morning& morning, const std::filesystem::path& store_folder) {
  const UtcTime issued = morning.windows.water.surround.field->snapshot().issued;
  const UtcTime from(day_of(morning.today ? morning.today->from : morning.windows.from));
  const auto failure = attempt([&] {
    morning.decisions = morning_decisions(morning.question.windows, morning.windows, from,
                                          morning.question.now.value_or(issued), store_folder);
  });
  if (failure)
    morning.windows.notes.push_back("the decisions of this site could not be read: " +
                                    failure->why);
}

}  // namespace

Morning today_of(const Morning& morning) {
  Morning today;
  today.question = morning.question;
  today.question.windows.from = morning.today->from;
  today.question.windows.to = morning.today->to;
  today.windows = *morning.today;
  return today;
}

void plan_anew(Morning& morning, const std::filesystem::path& store_folder) {
  if (!morning.plan_file) return;
  const PlanFile& file = *morning.plan_file;
  const auto failure = attempt([&] {
    expect_of_the_day(file, morning);
    WindowsQuestion question = morning.question.windows;
    question.from = UtcTime(day_of(morning.windows.from));
    question.to = *question.from + std::chrono::days(1);
    question.water.reset();
    question.past.reset();
    question.shift.reset();  // the hours of its crews and vessels are the plan's own
    if (file.site.id == morning.windows.site_id) {
      question.water = morning.windows.water;
      question.past = morning.windows.past;
    }
    const DayChances windows =
        windows_for_plan(file, question, store_folder, morning.windows.tasks);
    MorningPlan made;
    made.problem = problem_of(file, windows, morning.question.windows.rule.marginal);
    made.answer.name = file.name;
    made.answer.site = file.site.id;
    made.answer.time_limit_s = morning.question.plan_limit_s;
    made.answer.plan = make_plan(made.problem, morning.question.plan_limit_s);
    morning.plan = std::move(made);
  });
  if (failure) morning.no_plan = failure->why;
}

Morning morning_of(const MorningQuestion& question, const std::filesystem::path& store_folder) {
  Morning morning;
  morning.question = question;
  morning.question.windows.may_leave_out = true;
  const auto read_plan = [&] {  // what is misspelt is said before anything is worked out
    if (!question.plan.empty()) morning.plan_file = load_plan_file(question.plan, store_folder);
  };
  if (!question.is_unattended)
    read_plan();
  else if (const auto failure = attempt(read_plan))
    morning.no_plan = failure->why;
  morning.windows = windows_of(morning.question.windows, store_folder);
  morning.today = hours_left_today(morning.question, morning.windows, store_folder);
  add_decisions(morning, store_folder);
  plan_anew(morning, store_folder);
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

}  // namespace slackwater::api
