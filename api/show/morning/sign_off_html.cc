#include "api/show/morning/sign_off_html.h"

#include <set>

#include "api/show/decisions/decision_words.h"
#include "api/show/morning/morning_clock.h"
#include "api/show/morning/task_words.h"
#include "api/show/report/time_text.h"
#include "api/show/windows/windows_answer.h"
#include "fields/base/encode/html.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

using Cells = std::vector<std::string>;

/// The forecast that is signed, so that it is found again: site, time of issue with its year, the
/// beginning of its checksum.
std::string forecast_line(const Morning& morning) {
  const ScenarioWater& water = morning.windows.water;
  return "On the forecast of " + morning.windows.site_name + " (" + morning.windows.site_id +
         ") issued " + format_utc(water.surround.field->snapshot().issued) + ", checksum " +
         water.forecast_sha256.substr(0, 12) + ". Times are UTC.";
}

std::string verdict_and_best(const TaskWindows& task, const MorningClock& clock) {
  return std::string(twin::name_of(task.verdict)) + ", " +
         best_text(task, [&](UtcTime time) { return clock.utc(time); });
}

const TaskWindows* named(const std::vector<TaskWindows>& tasks, const std::string& id) {
  for (const TaskWindows& task : tasks)
    if (task.id == id) return &task;
  return nullptr;
}

/// "today: no-go, best 20:00, 31 %; Fri 14 Mar: go, best 06:30, 93 %".
std::string program_says(const Morning& morning, const TaskWindows& task) {
  std::string says = verdict_and_best(task, MorningClock(morning));
  if (!morning.today) return says;
  const TaskWindows* today = named(morning.today->tasks, task.id);
  return "today: " +
         (today == nullptr ? std::string("no start")
                           : verdict_and_best(*today, MorningClock(today_of(morning)))) +
         "; " + date_text(morning.windows.from) + ": " + says;
}

/// Decision, start, name and time; empty boxes where nothing was decided.
Cells boxes_of(const DecisionAnswer* decision) {
  if (decision == nullptr) return Cells(4);
  const PageClock utc;
  const store::DecisionRow& row = decision->row;
  return {word_of(row.decided) + (row.turbine.empty() ? "" : ", " + row.turbine),
          utc.stamp(row.start), row.by,
          utc.stamp(row.recorded_at) + (decision->is_late ? ", after the start" : "")};
}

std::string row_html(const std::string& task, const std::string& says, const Cells& boxes) {
  std::string html =
      "<tr><th scope=\"row\">" + escaped_html(task) + "</th><td>" + escaped_html(says) + "</td>";
  for (const std::string& box : boxes) html += "<td class=\"box\">" + escaped_html(box) + "</td>";
  return html + "</tr>\n";
}

/// What was decided about a task; null where nothing was.
const std::vector<DecisionAnswer>* decided_about(const Morning& morning, const std::string& id) {
  if (!morning.decisions) return nullptr;
  const auto found = morning.decisions->by_task.find(id);
  return found == morning.decisions->by_task.end() ? nullptr : &found->second;
}

/// One row, or one a decision.
std::string rows_html(const Morning& morning, const std::string& id, const std::string& name,
                      const std::string& says) {
  const std::vector<DecisionAnswer>* decided = decided_about(morning, id);
  if (decided == nullptr) return row_html(name, says, boxes_of(nullptr));
  std::string html;
  for (const DecisionAnswer& one : *decided)
    html += row_html(name, html.empty() ? says : std::string(), boxes_of(&one));
  return html;
}

std::string all_rows(const Morning& morning) {
  std::string html;
  std::set<std::string> told;
  for (const TaskWindows* task : by_verdict(morning)) {
    html += rows_html(morning, task->id, task->name, program_says(morning, *task));
    told.insert(task->id);
  }
  for (const TaskLeftOut& left : morning.windows.left_out) {
    html += rows_html(morning, left.task, left.task, "unknown");
    told.insert(left.task);
  }
  if (!morning.decisions) return html;
  for (const auto& [id, decisions] : morning.decisions->by_task)
    if (!told.contains(id))
      for (const DecisionAnswer& one : decisions)
        html += row_html(task_and_place(one.row), "not asked", boxes_of(&one));
  return html;
}

}  // namespace

std::string sign_off_html(const Morning& morning) {
  std::string html =
      "<section id=\"sign-off\" class=\"sign-off\"><h2>Sign-off</h2><p>" +
      escaped_html(forecast_line(morning)) +
      "</p><div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Sign-off\"><table>"
      "<thead><tr><th>Task</th><th>The program says</th><th>Decision</th><th>Start</th>"
      "<th>Name</th><th>Time</th></tr></thead><tbody>\n" +
      all_rows(morning) + "</tbody></table></div>";
  const std::string record =
      morning.decisions ? record_text(morning.decisions->record) : std::string();
  if (!record.empty())
    html += "<p class=\"note\">" +
            escaped_html(formatted("Decisions of the last {} days: ", record_goes_back.count()) +
                         record + ".") +
            "</p>";
  return html + "</section>\n";
}

}  // namespace slackwater::api
