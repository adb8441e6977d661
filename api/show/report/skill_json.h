#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// The JSON list that `verify`, `hindcast` and `demo` share (api/docs/json.md).
[[nodiscard]] nlohmann::json skill_list(const std::vector<calibration::SkillEntry>& entries);
/// The same as text, an entry a line.
[[nodiscard]] std::string skill_json(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
