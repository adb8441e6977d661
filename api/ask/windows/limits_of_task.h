#pragma once
#include "api/ask/windows/task_outlook.h"

namespace slackwater::api {

/// Lays all that the chances of a task are worked out from into `outlook.question`: the limits of
/// every worker at the steps of the phases that they name, in each future, the hours that are open,
/// and the time that visits want. Names them in `out`.
/// @param outlook  with its workers planned and its grid laid
void watch(const WindowsQuestion& question, const SharedOutlook& shared, const TaskSheet& sheet,
           Outlook& outlook, TaskWindows& out);

}  // namespace slackwater::api
