#pragma once
#include <optional>
#include <string>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::calibration {

/// The pairs of days of one method that belong together: same variable, wind policy, column, band
/// and lead. Pairs weigh the same; intervals draw whole pairs.
struct SkillSet {
  /// The last pair's entry, for what all share; with the longest averaging of any pair's truth, and
  /// in hindsight where any pair is.
  SkillEntry of;
  UtcDay first_day{};
  UtcDay last_day{};
  SetScore score;
};

/// The sets of a list of entries, in the order in which they first appear, and for each entry the
/// index of its set.
struct SkillSets {
  std::vector<SkillSet> sets;
  std::vector<std::size_t> of_entry;
};
[[nodiscard]] SkillSets sets_of(const std::vector<SkillEntry>& entries);

/// Whether a lead bin is one hour of lead rather than a day.
[[nodiscard]] bool is_hour(const LeadBin& lead) noexcept;

/// The entries that speak for the whole current under a wind policy: pooled over columns, over the
/// widest depth band (the shallower of equals) under which it was scored, all leads but single
/// hours.
[[nodiscard]] std::vector<SkillEntry> whole_current(const std::vector<SkillEntry>& entries,
                                                    WindPolicy wind);

/// "0-5 m", "below 50 m", "0-5 m above the bed", "all depths", "surface".
[[nodiscard]] std::string band_text(const std::optional<DepthBand>& band);
/// "0-24 h".
[[nodiscard]] std::string lead_text(const LeadBin& lead);

}  // namespace slackwater::calibration
