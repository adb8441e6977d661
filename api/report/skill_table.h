#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// One table for people: the whole current under one wind policy, a row a method, best first, the
/// forecast's row marked; a column a day of lead. The rest is in `skill_table`.
[[nodiscard]] std::string short_skill_table(const std::vector<calibration::SkillEntry>& entries,
                                            WindPolicy wind);

/// All tables: per variable, band and lead one row a method, pairs of days weighing the
/// same, best first; hours of lead are left to `hourly_table`.
[[nodiscard]] std::string skill_table(const std::vector<calibration::SkillEntry>& entries);

/// One row an hour of lead, one column a method: the vector RMSE over the first band.
[[nodiscard]] std::string hourly_table(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
