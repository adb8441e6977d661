#pragma once
#include <string>
#include <vector>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// What would change the answer of a task that is not a go, most first: the limits without which
/// its best start had a better chance, and what its flights, done otherwise, say. Empty for a go.
[[nodiscard]] std::vector<std::string> help_words(const Morning& morning, const TaskWindows& task);

}  // namespace slackwater::api
