#pragma once
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// One table for people: the whole current under one wind policy, a row a method, best first as a
/// share of our error over the same values, the forecast's row marked; a column a day of lead.
/// Under a baseline that has fewer days or values than the forecast stands what the forecast has
/// there. The rest is in `skill_table`.
[[nodiscard]] std::string short_skill_table(const std::vector<calibration::SkillEntry>& entries,
                                            WindPolicy wind,
                                            ForecastOrigin origin = ForecastOrigin::forecast);

/// All tables: per variable, band and lead one row a method, pairs of days weighing the
/// same, best first; hours of lead are left to `hourly_table`.
[[nodiscard]] std::string skill_table(const std::vector<calibration::SkillEntry>& entries);

/// One row an hour of lead, one column a method: the vector RMSE over the first band.
[[nodiscard]] std::string hourly_table(const std::vector<calibration::SkillEntry>& entries);

}  // namespace slackwater::api
