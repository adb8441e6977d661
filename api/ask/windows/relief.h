#pragma once
#include <vector>

#include "api/ask/windows/task_outlook.h"

namespace slackwater::api {

/// Less than this more is not worth saying.
inline constexpr double least_relief = 0.05;

/// Holds the task's limits against all futures again, each time without one of those that stop a
/// start. @return those without which its best start has a better chance, the best of them first
[[nodiscard]] std::vector<Relief> reliefs_of(const Outlook& outlook, const TaskWindows& task);

}  // namespace slackwater::api
