#pragma once
#include <map>
#include <optional>
#include <vector>

#include "calibration/skill/vector_tally.h"
#include "calibration/verify/skill_entry.h"

namespace slackwater::calibration {

/// Tallies by depth band and hour of lead; every score asked for is a sum of them.
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
  /// Squared errors of a lead bin by its hours, in their order, for the bootstrap.
  [[nodiscard]] std::vector<BlockSum> squares_by_hour(std::size_t band, const LeadBin& lead) const;

 private:
  std::size_t hours_;
  std::vector<VectorTally> tally_;  ///< band x hour, hour fastest
};

/// What one method adds up to, held against our forecast value by value.
class MethodTallies {
 public:
  MethodTallies(std::size_t bands, std::size_t hours)
      : common_(bands, hours), ours_(bands * hours) {}

  /// A value that our forecast has too.
  /// @param ours_squared_error  of our forecast there, m^2/s^2
  void add(std::size_t band, std::size_t hour, const PairContribution& pair,
           double ours_squared_error) noexcept;
  /// A value that our forecast lacks.
  void add_alone(std::size_t band, std::size_t hour, const PairContribution& pair);
  void merge(const MethodTallies& other);

  /// Over the values that our forecast has too; of our forecast itself, over all.
  [[nodiscard]] const HourlyTallies& common() const noexcept { return common_; }
  /// Over the values that our forecast lacks; null where there is none.
  [[nodiscard]] const HourlyTallies* alone() const noexcept { return alone_ ? &*alone_ : nullptr; }
  /// Squared errors of our forecast over the common values of a lead bin.
  [[nodiscard]] BlockSum ours(std::size_t band, const LeadBin& lead) const;

 private:
  HourlyTallies common_;
  std::vector<BlockSum> ours_;          ///< band x hour, hour fastest
  std::optional<HourlyTallies> alone_;  ///< made when it is needed
};

using TalliesByMethod = std::map<Method, MethodTallies>;
void merge(TalliesByMethod& all, const TalliesByMethod& more);

/// The hour h of lead that a time falls into, (h, h + 1]; nothing at or before the end of D.
[[nodiscard]] std::optional<std::size_t> hour_of_lead(UtcTime end_of_day, UtcTime time) noexcept;

/// The entries of all methods for the options' bands and leads, and for each hour of lead of the
/// first band, on the pattern of `blank`. A baseline's entry is of the values that our forecast has
/// too; where our forecast has none in that band and lead, of its own. Entries without any value
/// are left out.
/// @param bands          the bands of the tallies
/// @param with_interval  whether to give each lead bin the bootstrap interval of its RMSE
[[nodiscard]] std::vector<SkillEntry> entries_of(const TalliesByMethod& methods,
                                                 const std::vector<DepthBand>& bands,
                                                 const VerifyOptions& options,
                                                 const SkillEntry& blank, bool with_interval);

}  // namespace slackwater::calibration
