#pragma once
#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "calibration/verify/skill_entry.h"
#include "calibration/verify/skill_set.h"

namespace slackwater::calibration {

/// A baseline beside our forecast, over the pairs of days, and of each the values, that both have.
struct BestBaseline {
  Method method = Method::persistence;
  std::size_t pairs = 0;     ///< that both have
  double rmse = 0;           ///< of the baseline over them, in the unit of the variable
  double forecast_rmse = 0;  ///< of our forecast over them
};

/// How our forecast stands beside its best baseline.
enum class Outcome {
  alone,   ///< no baseline has enough pairs
  ahead,   ///< the forecast is better
  tie,     ///< the difference is within noise
  beaten,  ///< the baseline is better
};

/// "alone", "ahead", "tie", "beaten".
[[nodiscard]] std::string_view name_of(Outcome outcome) noexcept;

/// How our forecast of a variable did, and whether any baseline did better. Every command, page
/// and document that says so says it by this rule:
///
/// - What is judged is one variable, the current unless another is named (over the widest depth
///   band, the shallower of equals), all columns pooled, in the first lead bin of more than an
///   hour. Each wind policy has its verdict,
///   and forecasts that were issued have one apart from hindcasts.
/// - Every method counts as a baseline, the provider's forecast too, but `oracle_mean`: it knows
///   the day itself.
/// - A baseline is held against our forecast over the pairs of days that both have, and within a
///   pair over the values that both have (`SkillEntry::forecast_rmse`); days and levels for which
///   it could not be made say nothing of it. It needs half of the forecast's pairs: one lucky day
///   is no rival.
/// - The best baseline is the one whose error is the smallest share of ours.
/// - With five pairs or more it is a tie where the 95 % interval of the mean difference of squared
///   errors (`bootstrap_mean` over the days in order) holds zero; fewer are few (`is_of_few`), and
///   then it is one where the errors differ by less than half a millimetre a second (of waves: half
///   a millimetre), which no table shows.
struct Verdict {
  WindPolicy wind = WindPolicy::best;
  ForecastOrigin origin = ForecastOrigin::forecast;
  SkillSet forecast;                 ///< our forecast over all its pairs
  std::optional<BestBaseline> best;  ///< nothing: no baseline has enough pairs
  Outcome outcome = Outcome::alone;
  [[nodiscard]] bool is_beaten() const noexcept { return outcome == Outcome::beaten; }
};

/// One verdict for each wind policy and origin of which our forecast was scored: issued forecasts
/// before hindcasts, each in the order of the policies. Pure; the order of the entries does not
/// matter.
[[nodiscard]] std::vector<Verdict> verdicts_of(const std::vector<SkillEntry>& entries);

/// The one to say where only one is said: of issued forecasts where there are any, of the wind
/// policy with the most pairs, the first of equals; nothing where no forecast was scored.
[[nodiscard]] std::optional<Verdict> main_verdict(const std::vector<SkillEntry>& entries);

/// The verdict on one wind policy; nothing where no forecast of this origin was scored under it.
/// @param variable  of a SkillEntry
[[nodiscard]] std::optional<Verdict> verdict_of(const std::vector<SkillEntry>& entries,
                                                WindPolicy wind,
                                                ForecastOrigin origin = ForecastOrigin::forecast,
                                                std::string_view variable = current_variable);

}  // namespace slackwater::calibration
