#pragma once
#include <string>

#include "api/ask/morning/recent_skill.h"

namespace slackwater::api {

/// "current 0.05 m/s, 38 % less than the best naive rival (same-hour)".
[[nodiscard]] std::string text_of(const RecentSkill& trust);

}  // namespace slackwater::api
