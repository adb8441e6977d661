#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "fields/base/step_clock.h"
#include "twin/climate/extreme_value.h"
#include "twin/climate/storm_peaks.h"

namespace slackwater::twin {

/// What is asked of the extremes of a series.
struct ExtremesQuestion {
  std::vector<double> return_years{1, 10, 50, 100};
  std::optional<double> threshold;  ///< absent: the greatest with so many storms a year
  double storms_per_year = 5;
  std::size_t separation_steps = 48;
  Duration value_step{0};        ///< how long a value holds, if longer than the clock's step
  std::size_t resamples = 1000;  ///< of the bootstrap
  std::uint64_t seed = 1;
};

// What a history has to have, by our own choice: what is less is not answered.
inline constexpr double least_years = 3;               ///< known, for peaks over a threshold
inline constexpr std::size_t least_storms = 20;        ///< over it
inline constexpr std::size_t least_gumbel_years = 10;  ///< complete, for maxima of years
inline constexpr std::size_t least_shape_years = 20;   ///< for a shape of their own
inline constexpr double complete_share = 0.9;          ///< known of a year that is complete
inline constexpr double month_share = 0.5;             ///< and of each of its months
/// A value holds no longer: the peaks of storms are lost in means of days and months.
inline constexpr Duration longest_step = std::chrono::hours(6);
/// A return value is answered up to so many times the history: the old rule of metocean practice is
/// three to four.
inline constexpr double most_histories = 4;
/// From here on a fit by moments means nothing: its law has no variance (extreme_value.h).
inline constexpr double most_shape = 0.5;

/// From the 5th to the 95th percentile of the resamples.
struct Interval90 {
  double low = 0;
  double high = 0;
};

enum class ReturnSupport {
  supported,
  beyond_history,   ///< more than `most_histories` times the history
  below_threshold,  ///< so common that storms above the threshold do not tell it
  below_year,       ///< less than a year, which maxima of years do not tell
  no_good_fit       ///< the fit is not `is_good`
};

/// What is exceeded once in so many years on average.
struct ReturnValue {
  double years = 0;
  ReturnSupport support = ReturnSupport::supported;
  double value = 0;  ///< this and the interval where it is supported alone
  Interval90 interval{};
};

/// Peaks over one threshold, generalised Pareto.
struct PeaksFit {
  /// Above it the fit has nothing; infinite for a shape of 0 and above.
  [[nodiscard]] double upper_end() const noexcept { return threshold + fit.greatest(); }
  /// Whether what was seen is possible by the fit, and its moments are there to fit it by.
  [[nodiscard]] bool is_good() const noexcept {
    return fit.shape < most_shape && upper_end() >= greatest_seen;
  }

  double threshold = 0;
  std::size_t storms = 0;
  double storms_per_year = 0;  ///< of what is known
  Pareto fit{};
  Interval90 shape{};
  double greatest_seen = 0;  ///< of the storms
  std::vector<ReturnValue> returns;
};

struct YearMaximum {
  int year = 0;
  std::size_t step = 0;
  double value = 0;
};

/// One distribution of the maxima of years.
struct MaximaFit {
  [[nodiscard]] bool is_good() const noexcept {
    return fit.shape < most_shape && fit.greatest() >= greatest_seen;
  }

  ExtremeValue fit{};
  double greatest_seen = 0;
  std::vector<ReturnValue> returns;
};

enum class NoPeaks {
  none,             ///< there is a fit
  coarse_steps,     ///< values hold longer than `longest_step` or the separation; no maxima either
  short_history,    ///< less than `least_years`
  seasons_missing,  ///< a month of the year is unknown, or thin (known_months.h)
  few_storms,       ///< fewer than `least_storms` over the threshold
  all_alike,        ///< no two peaks differ
  no_good_fit       ///< `peaks` is there, but not `is_good`, and has no return value
};

/// The extremes of a series.
struct Extremes {
  /// Whether the threshold has as many storms as were looked for; else it is the one with most.
  [[nodiscard]] bool has_rate() const noexcept {
    return static_cast<double>(storms_found) >= rate * years_known;
  }

  double years_known = 0;  ///< steps that are known, in years of 365.25 days
  NoPeaks no_peaks = NoPeaks::none;
  std::vector<int> months_missing;  ///< 1 to 12: those of `seasons_missing`
  double rate = 0;  ///< storms a year that a threshold was looked for with; 0: it was given
  std::size_t storms_found = 0;  ///< over the threshold, or over the best of all that were tried
  double separation_h = 0;
  double step_h = 0;        ///< of the clock
  double value_step_h = 0;  ///< of the series' own values
  std::optional<PeaksFit> peaks;
  std::vector<PeaksFit> other_thresholds;  ///< ascending, that of `peaks` among them
  std::vector<YearMaximum> maxima;         ///< of the years that are complete
  std::optional<MaximaFit> gumbel;
  std::optional<MaximaFit> extreme_value;
};

/// Return values by peaks over a threshold, and by the maxima of calendar years (UTC):
///
///   x(T) = u + y,  P(Y > y) = 1 / (rate T)       storms as a Poisson process (Coles 2001, 4.3.3)
///   x(T) not exceeded with exp(-1 / T)            maxima of years
///
/// Both mean the same T: the mean time between exceedances. A maximum's usual 1 - 1/T differs from
/// exp(-1/T) for short T alone. Of less than a year maxima of years say nothing: the storms do.
///
/// Intervals by the parametric bootstrap: samples drawn from the fit, as many storms as a Poisson
/// number, fitted again. They know the scatter of the sample, not that the fit may be the wrong
/// form, nor that climates change.
///
/// @param values  one a step, NaN where nobody knows
[[nodiscard]] Extremes extremes_of(std::span<const double> values, const StepClock& clock,
                                   const ExtremesQuestion& question);

// The parts, for themselves.

/// The fit of peaks over one threshold; nothing of fewer than three, or where all are alike.
/// @param years  that are known, > 0
[[nodiscard]] std::optional<PeaksFit> peaks_fit(std::span<const StormPeak> peaks, double threshold,
                                                double years, const ExtremesQuestion& question);

/// @param maxima  of years, 3 at least  @param has_shape  generalised; else Gumbel's
[[nodiscard]] std::optional<MaximaFit> maxima_fit(const std::vector<double>& maxima, bool has_shape,
                                                  const ExtremesQuestion& question);

/// The greatest value of each calendar year that is complete.
[[nodiscard]] std::vector<YearMaximum> year_maxima(std::span<const double> values,
                                                   const StepClock& clock);

}  // namespace slackwater::twin
