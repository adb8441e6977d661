#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/ask/morning/morning.h"
#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// For programs, and what the operator's hook reads: api/docs/report.md has the schema.
/// @param past      of past forecasts
/// @param verified  how they did, in words; may be empty
[[nodiscard]] nlohmann::json morning_json(const Morning& morning,
                                          const std::vector<calibration::SkillEntry>& past,
                                          const std::string& verified);

}  // namespace slackwater::api
