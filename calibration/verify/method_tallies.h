#pragma once
#include <map>
#include <vector>

#include "calibration/skill/vector_tally.h"
#include "calibration/verify/skill_entry.h"

namespace slackwater::calibration {

/// The tallies of one method by depth band and hour of lead; every score asked for is a sum of
/// them.
class HourlyTallies {
 public:
  HourlyTallies(std::size_t bands, std::size_t hours) : hours_(hours), tally_(bands * hours) {}
  [[nodiscard]] std::size_t hours() const noexcept { return hours_; }
  /// Hour h is the lead (h, h + 1].
  [[nodiscard]] VectorTally& at(std::size_t band, std::size_t hour) noexcept {
    return tally_[band * hours_ + hour];
  }
  [[nodiscard]] const VectorTally& at(std::size_t band, std::size_t hour) const noexcept {
    return tally_[band * hours_ + hour];
  }
  void merge(const HourlyTallies& other) noexcept;

  /// The sum over a lead bin.
  [[nodiscard]] VectorTally over(std::size_t band, const LeadBin& lead) const;
  /// Squared errors of a lead bin in blocks of six hours, for the bootstrap.
  [[nodiscard]] std::vector<BlockSum> six_hour_blocks(std::size_t band, const LeadBin& lead) const;

 private:
  std::size_t hours_;
  std::vector<VectorTally> tally_;  ///< band x hour, hour fastest
};

using TalliesByMethod = std::map<Method, HourlyTallies>;
void merge(TalliesByMethod& all, const TalliesByMethod& more);

/// The hour h of lead that a time falls into, (h, h + 1]; nothing at or before the end of D.
[[nodiscard]] std::optional<std::size_t> hour_of_lead(UtcTime end_of_day, UtcTime time) noexcept;

/// The entries of all methods for the options' bands and leads, and for each hour of lead of the
/// first band, on the pattern of `blank`; those without any value are left out.
/// @param bands          the bands of the tallies
/// @param with_interval  whether to give each lead bin the block bootstrap interval of its RMSE
[[nodiscard]] std::vector<SkillEntry> entries_of(const TalliesByMethod& methods,
                                                 const std::vector<DepthBand>& bands,
                                                 const VerifyOptions& options,
                                                 const SkillEntry& blank, bool with_interval);

}  // namespace slackwater::calibration
