#pragma once
#include <string>
#include <vector>

#include "calibration/verify/verdict.h"

namespace slackwater::api {

/// How one variable was forecast: the verdict of `calibration::verdict_of` on it.
struct RecentSkill {
  std::string variable;  ///< as people say: "current", "wind", "wave height"
  std::string unit;      ///< "m/s", "m"
  calibration::Verdict verdict;
};

/// A line a variable that was scored; empty before any truth is in.
/// @param entries  of the first day of lead
[[nodiscard]] std::vector<RecentSkill> trust_of(const std::vector<calibration::SkillEntry>& entries,
                                                WindPolicy wind);

/// The entries of the newest issued forecast that was scored.
[[nodiscard]] std::vector<calibration::SkillEntry> newest_day_of(
    const std::vector<calibration::SkillEntry>& entries, WindPolicy wind);

}  // namespace slackwater::api
