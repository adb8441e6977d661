#pragma once
#include <string>

#include "api/ask/morning/morning.h"

namespace slackwater::api {

/// What to do when: the plan as tables, by time, the vessels' ways, what is left and why; why there
/// is none where it could not be made. Empty where no plan was asked for. Escaped.
[[nodiscard]] std::string plan_html(const Morning& morning);

}  // namespace slackwater::api
