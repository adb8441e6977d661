#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// The JSON list that `verify` and `hindcast` share (api/docs/json.md).
[[nodiscard]] std::string skill_json(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
