#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "fields/record/choose.h"

namespace slackwater::calibration {

/// Days with an analysed wind that a check takes: errors of weather forecasts last half a day
/// (forecast_wind_error), so that each day is a witness of its own. With ten a spread of half the
/// right size is told from a right one, and one that is off by a fifth is not
/// (tests/calibration/day/spread_check_test.cc).
inline constexpr std::size_t fewest_checked_days = 10;
/// A factor beyond these is a fault of the ensemble, not of its spread. Ensembles of weather spread
/// too little in the first days (Buizza et al. 2005, Mon. Wea. Rev. 133, 1076), near the surface by
/// up to a half; ours.
inline constexpr double least_spread_factor = 0.5;
inline constexpr double most_spread_factor = 3.0;

/// What the past runs of a weather ensemble have met on one day of lead.
struct CheckedLead {
  std::size_t days = 0;       ///< whose analysed wind they were held against
  double rms_error_m_s = 0;   ///< of a component of the members' mean; 0 without days
  double rms_spread_m_s = 0;  ///< of the same, were the truth one more member
  double factor = 1;          ///< on the spread: 1 where it is not checked, or in keeping
  [[nodiscard]] bool is_checked() const noexcept { return days >= fewest_checked_days; }
};

/// An ensemble's spread held against the error of its mean, by day of lead.
struct SpreadCheck {
  std::vector<CheckedLead> lead;  ///< of (0 h, 24 h] after the reference time, (24 h, 48 h], ...

  [[nodiscard]] bool is_checked() const noexcept;
  /// The factor at a lead: each checked day's own at its middle, linear in between, held outside.
  [[nodiscard]] double factor_at(double lead_h) const noexcept;
};

/// Holds past runs of an ensemble against the wind as analysed since:
///
///   error^2  = mean |x_mean - truth|^2 / 2
///   spread^2 = mean (m + 1)/m sum_n |x_n - x_mean|^2 / (2 (m - 1))        of m members
///   factor   = error / spread, where 1 lies outside the 95 % interval of the ratio; else 1
///
/// Were the truth one more member the two would be equal (Fortin et al. 2014, J. Hydrometeor. 15,
/// 1708). Days of valid time weigh the same, whatever their number of values; the interval
/// is a bootstrap of days (calibration/skill/bootstrap.h). Bounded to [`least_spread_factor`,
/// `most_spread_factor`].
///
/// The analysis stands for the truth: its own error counts as the ensemble's, on the wide side.
///
/// @param dataset  of the ensemble; the runs of others say nothing of it
/// @param truth    the wind as chosen; of it what was analysed or observed counts, at the members'
///                 own times or between values at most two hours apart
/// @param until    truth after this is not looked at
[[nodiscard]] SpreadCheck check_spread(const VectorRecord& wind, const std::string& dataset,
                                       const Knowledge& knowledge, const VectorColumn& truth,
                                       UtcTime until);

/// "its spread is not checked yet: 3 days with an analysed wind are stored, 10 are needed", or "its
/// spread was checked against its error: day 1 agrees (1.1 of 1.0 m/s, 21 days), day 2 times 1.9
/// (2.1 of 1.1 m/s, 20 days)".
[[nodiscard]] std::string text_of(const SpreadCheck& check);

}  // namespace slackwater::calibration
