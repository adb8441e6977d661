#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "calibration/verify/skill_entry.h"

namespace slackwater::calibration {

/// The pairs of days of one method that belong together: same variable, origin, wind policy,
/// column, band and lead. Pairs weigh the same, and a day is one pair: of several forecasts of one
/// day the one issued first counts. Days on which a baseline alone was scored are left out where
/// there are others.
struct SkillSet {
  /// The last pair's entry, for what all share; with the longest averaging of any pair's truth, and
  /// in hindsight, or with a simulated wind, where any pair is.
  SkillEntry of;
  UtcDay first_day{};
  UtcDay last_day{};
  SetScore score;
  /// Of our own forecast over exactly the days and values of this set, in the unit of `score.rmse`:
  /// the only error of ours that stands beside it. Empty as in `SkillEntry::forecast_rmse`.
  std::optional<double> forecast_rmse;
};

/// The sets of a list of entries, in the order in which they first appear, and for each entry the
/// index of its set.
struct SkillSets {
  std::vector<SkillSet> sets;
  std::vector<std::size_t> of_entry;
};
[[nodiscard]] SkillSets sets_of(const std::vector<SkillEntry>& entries);

/// Whether a set of a baseline holds fewer days or values than our forecast's of the same band and
/// lead: then its error says nothing beside `ours.score`, only beside its own `forecast_rmse`.
[[nodiscard]] bool is_part_of(const SkillSet& baseline, const SkillSet& ours) noexcept;

/// Which of two sets of one band and lead stands first in a table: of smaller error as a share of
/// our forecast's over the same values (our own: 1); those without such a share last, by error.
[[nodiscard]] bool is_better(const SkillSet& a, const SkillSet& b) noexcept;

/// Whether a lead bin is one hour of lead rather than a day.
[[nodiscard]] bool is_hour(const LeadBin& lead) noexcept;

/// The entries that speak for all of a variable under a wind policy and of an origin: pooled over
/// columns, over the widest depth band (the shallower of equals) under which it was scored, all
/// leads but single hours.
[[nodiscard]] std::vector<SkillEntry> whole_of(const std::vector<SkillEntry>& entries,
                                               std::string_view variable, WindPolicy wind,
                                               ForecastOrigin origin);
/// Of the current.
[[nodiscard]] std::vector<SkillEntry> whole_current(const std::vector<SkillEntry>& entries,
                                                    WindPolicy wind, ForecastOrigin origin);

/// "0-5 m", "below 50 m", "0-5 m above the bed", "all depths", "surface".
[[nodiscard]] std::string band_text(const std::optional<DepthBand>& band);
/// "0-24 h".
[[nodiscard]] std::string lead_text(const LeadBin& lead);

}  // namespace slackwater::calibration
