#pragma once
#include <string>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// "Go for 5 of 8 tasks on Tue 11 Mar; 2 marginal, 1 not worked out."
[[nodiscard]] std::string headline_of(const Morning& morning);
/// "Today: go for 1 of 8 tasks from Mon 10 Mar 05:00 to Tue 11 Mar 00:00; 7 no-go."; empty where no
/// hours are left today.
[[nodiscard]] std::string today_headline_of(const Morning& morning);

/// For people at a terminal: the headline, a line a task (go first, at most eight; how many more
/// there are), in ten lines at most with the one that the caller adds.
[[nodiscard]] std::string morning_text(const Morning& morning);

}  // namespace slackwater::api
