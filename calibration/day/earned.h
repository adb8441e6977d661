#pragma once
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "calibration/blend/blend.h"
#include "calibration/blend/earned_spread.h"
#include "calibration/day/part_failure.h"
#include "calibration/day/rehearsed_day.h"

namespace slackwater::calibration {

/// What the past of a site has earned: the weights of the candidates, and the factor on the spread.
struct Earned {
  Blend blend;               ///< of the first day of lead
  std::vector<Blend> later;  ///< of the second, third, ..., as far as days were rehearsed
  EarnedSpread spread;
  std::size_t simulated_days = 0;        ///< rehearsed with a run of the wind that was simulated
  std::size_t failed_days = 0;           ///< that could not be rehearsed as they should
  std::optional<Failure> first_failure;  ///< of them
};

/// A rehearsed day as evidence on one of its days of lead.
struct PastLead {
  std::shared_ptr<const RehearsedDay> day;
  std::size_t lead = 0;  ///< 0: the first
  double age_days = 0;   ///< from the end of that day of lead to the D that is forecast from
};

/// What rehearsed days have earned: blend and spread. The weights of each later day of lead have
/// those of the day before it as their prior: few pairs leave them there, as they do the spread.
/// The spread is held against weights that the other pairs earned; that prior has seen hours of
/// theirs all the same, for the days of lead of neighbouring days overlap.
/// @param past  per day of lead, at least the first
[[nodiscard]] Earned earned_from(std::span<const std::vector<PastLead>> past,
                                 std::span<const Candidate> candidates);

/// The weights of the candidates at a lead, hours after the end of D: those of a day of lead at its
/// middle, on a line between, held before the first middle and after the last.
[[nodiscard]] std::vector<double> weights_at(const Earned& earned, double lead_h);

/// Whether the provider's forecast has a part in any day of lead.
[[nodiscard]] bool uses_provider(const Earned& earned);

/// The standard deviation that the blend of those weights states, before the earned factor:
///
///   sigma^2 = (1 - w_m) s_o^2 + w_m s_m^2
///
/// w_m: weight of `merged`, s_m its standard deviation (our own where it is NaN); all other
/// candidates are as uncertain as our own forecast.
[[nodiscard]] double sigma_of_blend(const Blend& blend, const std::vector<double>& weights,
                                    double own_sigma_m_s, double merged_sigma_m_s);

}  // namespace slackwater::calibration
