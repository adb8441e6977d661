#pragma once
#include <string>
#include <vector>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// "A01, 1.5 h and 0.5 h in hand".
[[nodiscard]] std::string where_and_how_long(const TaskWindows& task);

/// Of its best start, in a few words: "best 10:30, 94 %"; "no start" where it has none.
/// @param clock  how people read a time
[[nodiscard]] std::string best_text(const TaskWindows& task,
                                    const std::function<std::string(UtcTime)>& clock);

/// What is said of a task below its row: the windows, the best start with its interval and what
/// binds it, what was flown, what would help, what the central forecast alone and practice would
/// say, and what was not checked. No line is empty.
[[nodiscard]] std::vector<std::string> task_words(const Morning& morning, const TaskWindows& task);

/// What the chances are, and how to read the picture.
[[nodiscard]] std::string rules_text(const Morning& morning);

}  // namespace slackwater::api
