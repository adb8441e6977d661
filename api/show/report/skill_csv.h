#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// The entries of `verify` and `hindcast` as a table for spreadsheets and pandas: a row each, the
/// numbers of `skill_json` under the same names, those of a list each in a column of its own
/// (api/docs/json.md). A cell without a value is empty.
[[nodiscard]] std::string skill_csv(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
