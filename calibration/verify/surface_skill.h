#pragma once
#include <vector>

#include "calibration/verify/skill_entry.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

/// Scores the wind and the waves of a forecast at its first column: against a moored instrument
/// where there is one, else the analysed product. Values that the forecast took from that same
/// analysis (`--wind best` over the past) are left out: they would score their own copy.
[[nodiscard]] std::vector<SkillEntry> score_surface(const ColumnData& data,
                                                    const Snapshot& snapshot, UtcTime end_of_day,
                                                    const VerifyOptions& options,
                                                    const SkillEntry& blank);

}  // namespace slackwater::calibration
