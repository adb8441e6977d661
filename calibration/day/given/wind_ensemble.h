#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "calibration/day/given/spread_check.h"
#include "fields/record/choose.h"
#include "fields/record/record.h"

namespace slackwater::calibration {

/// One member of a weather ensemble at the stamps of a forecast.
struct WindMember {
  int number = 0;                    ///< the provider's; 0 would be the control
  std::vector<Horizontal> wind_m_s;  ///< 10 m, towards, at the stamps; NaN beyond the member's ends
};

/// One run of a weather ensemble: whose wind it is.
struct WindEnsembleRun {
  std::string product_id;
  std::string dataset;
  UtcTime reference_time{};
  std::vector<int> number;             ///< of its perturbed members, ascending
  std::vector<const Origin*> origins;  ///< of their pieces, owned by the data
  SpreadCheck spread;                  ///< what its product's past runs have met
};

/// The perturbed members of a run at one place, as stored. The control is none of them: it is the
/// centre that they are perturbed from.
struct WindEnsemble {
  WindEnsembleRun run;
  std::vector<VectorColumn> members;  ///< in the order of `run.number`; one level, values only
};

/// Fewer members are no ensemble: five, two components each, know their spread to a fourth of it.
inline constexpr std::size_t fewest_wind_members = 5;

/// The newest ensemble run that is known and says enough of the stamps: at least five members that
/// reach from the first stamp, or from where the run begins, over 24 h or to the last stamp. Of one
/// reference time the run with more members, then the dataset that is first by name. Nothing where
/// no run is like that. Pieces of one member (step ranges in files of their own) are joined, the
/// later ingested wins; the order of pieces does not matter.
[[nodiscard]] std::optional<WindEnsemble> newest_wind_ensemble(const VectorRecord& wind,
                                                               const Knowledge& knowledge,
                                                               std::span<const UtcTime> stamps);

/// The runs of one dataset that are known and were issued before `until`, the earliest first, each
/// with its perturbed members up to then.
[[nodiscard]] std::vector<WindEnsemble> wind_ensembles(const VectorRecord& wind,
                                                       const std::string& dataset,
                                                       const Knowledge& knowledge, UtcTime until);

/// The members at the stamps: linear in time within the run, NaN beyond a member's ends and across
/// gaps of more than 12 h.
[[nodiscard]] std::vector<WindMember> members_at(const WindEnsemble& ensemble,
                                                 std::span<const UtcTime> stamps);

}  // namespace slackwater::calibration
