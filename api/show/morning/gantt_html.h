#pragma once
#include <string>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// When each task can begin: a row a task with its verdict in words, the chance of every start as a
/// column of its height, and the best start with what binds it. Told apart without colour: a go is
/// full, marginal is hatched, less is pale. Escaped.
[[nodiscard]] std::string gantt_html(const Morning& morning);
/// The same of the hours that are left today, with fewer words; empty where there are none.
[[nodiscard]] std::string gantt_today_html(const Morning& morning);

}  // namespace slackwater::api
