#pragma once
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::api {

/// Prints skill for people: one verdict and one table, with `full` every verdict and table.
void print_skill(const std::vector<calibration::SkillEntry>& entries, bool full);

}  // namespace slackwater::api
