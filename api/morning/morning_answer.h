#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/morning/morning.h"
#include "api/morning/past_skill.h"

namespace slackwater::api {

/// For programs, and what the operator's hook reads: api/docs/report.md has the schema.
[[nodiscard]] nlohmann::json morning_json(const Morning& morning, const PastSkill& past);

/// For people at a terminal: the headline, a line a task (go first, at most eight; how many more
/// there are), in ten lines at most with the one that the caller adds.
[[nodiscard]] std::string morning_text(const Morning& morning);

}  // namespace slackwater::api
