#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// A table for people: per variable, band and lead one row a method, pairs of days weighing the
/// same, best first; hours of lead are left to `hourly_table`.
[[nodiscard]] std::string skill_table(const std::vector<calibration::SkillEntry>& entries);

/// One row an hour of lead, one column a method: the vector RMSE over the first band.
[[nodiscard]] std::string hourly_table(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
