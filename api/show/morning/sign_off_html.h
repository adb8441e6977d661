#pragma once
#include <string>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// Where a coordinator signs: which forecast it is, a row a task with what the program says, and
/// boxes for the decision, the start, a name and the time; filled where the store holds decisions
/// of the day. Below it the record of past decisions, where there is one. Escaped.
[[nodiscard]] std::string sign_off_html(const Morning& morning);

}  // namespace slackwater::api
