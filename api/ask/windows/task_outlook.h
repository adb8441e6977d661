#pragma once
#include <string>
#include <vector>

#include "api/ask/windows/task_sheet.h"
#include "api/ask/windows/task_windows.h"
#include "fields/base/step_clock.h"
#include "twin/rehearse/limit_ahead.h"

namespace slackwater::api {

/// Everything of one task that the chances are worked out from.
struct Outlook {
  LoadedMission mission;
  twin::ReadyRun ready;
  StepClock clock;
  twin::StartSteps starts;
  twin::StartQuestion question;
  std::vector<twin::LimitAhead> ahead;
  std::vector<std::vector<double>> gates;
};

/// The mission of a task at the turbines that were asked for, else at the first at which there is
/// such work. @throws Error(invalid_input), Error(not_found)
[[nodiscard]] LoadedMission laid_out(const SharedOutlook& shared, const WindowsQuestion& question,
                                     const std::string& task);

/// Phases, planned time and contingency of every worker of `outlook.ready`.
void plan_work(const WindowsQuestion& question, const TaskSheet& sheet, const Outlook& outlook,
               TaskWindows& out);

/// The grid of the starts, as many as there is forecast for from beginning to end. Visits are made
/// within the hours that were asked for; what is done in one go may end later.
/// @throws Error(invalid_input) where no start fits, or the task is longer than its day
void lay_grid(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
              Outlook& outlook, TaskWindows& out);

/// For how long after a start a task is out, all of it or its shortest visit.
[[nodiscard]] twin::StepRanges whole_stay(const Outlook& outlook, const TaskWindows& out);

}  // namespace slackwater::api
