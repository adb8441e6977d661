#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace slackwater::calibration {

/// How the errors of one past pair compare with the spread that was forecast: a histogram of
/// |z| = |forecast - truth| / sigma over both components of all its values. Small, whatever their
/// number.
class NormalisedErrors {
 public:
  static constexpr double bin_width = 0.1;
  static constexpr std::size_t bins = 60;  ///< to |z| = 6; one more holds what lies beyond

  /// One component. An error or sigma that is not finite, or a negative sigma, is not counted; an
  /// error without sigma lies beyond the last bin.
  void add(double error, double sigma) noexcept;
  [[nodiscard]] double count() const noexcept { return total_; }
  /// Share of all that lies in a bin.
  [[nodiscard]] double share(std::size_t bin) const noexcept;

 private:
  std::array<double, bins + 1> in_bin_{};
  double total_ = 0;
};

struct PastSpread {
  double age_days = 0;                  ///< of the first day of lead; >= 0
  NormalisedErrors errors;              ///< of the first day of lead
  std::vector<NormalisedErrors> later;  ///< of the second, the third, ... as far as it is known
};

struct SpreadSettings {
  /// A band needs more pairs than a weight: a tail is seen less often than a mean.
  double forgetting_days = 30.0;
  /// Pairs' worth of belief that sigma is right as forecast. 1 to 3 do alike for errors in keeping
  /// with it; with 5 a spread that is wrong by half is still at 73 % after ten pairs, with 2 at
  /// 76 %.
  double prior_pairs = 2.0;
  /// A factor beyond these is a fault of the forecast, not of its spread.
  double least = 0.5;
  double most = 2.0;
};

/// What a later day of lead has earned.
struct LaterSpread {
  double scale = 1.0;
  std::size_t pairs = 0;
  double past_coverage_80 = 0.8;  ///< of the unscaled band; 0.8 without pairs
};

struct EarnedSpread {
  /// The spread as forecast times this covers as it should on the first day of lead.
  double scale = 1.0;
  std::size_t pairs = 0;          ///< past pairs used
  double past_coverage_80 = 0.8;  ///< of the unscaled band over them, forgetting; 0.8 without pairs
  std::vector<LaterSpread> later;  ///< of the second day of lead, the third, ...
  std::string provenance;          ///< one sentence

  /// The factor at a lead: each day's own, passing linearly from one to the next over the six hours
  /// about its end, so that no band jumps at midnight; held before the first and after the last.
  [[nodiscard]] double scale_at(double lead_h) const noexcept;
};

/// The factor on sigma with which the central 80 % band would have held 80 % of the past:
///
///   scale = q / 1.2816,   q: the 80 % quantile of |z| in  sum_i g_i h_i + n_0 h_normal
///
/// h_i: histogram of pair i with sum 1 (pairs weigh the same, whatever their number of values),
/// g_i = exp(-age/forgetting), n_0 = `prior_pairs`, h_normal that of a standard normal; linear
/// within a bin. Bounded to [least, most].
///
/// Each later day of lead has a factor of its own, from what the same past forecasts met on that
/// day: a wind that errs more, a memory that forgets otherwise than believed. Its prior is the
/// factor of the day before it, n_0 pairs' worth: few pairs leave it there, none leave it wholly.
///
/// Why not sqrt(mean z^2): after thirty pairs of which each has but four independent parts it
/// covers 81 % of errors that are normal, 85 % of those like Student's t of 3 degrees, 90 % where
/// one in twenty is eight times too large; this one 80, 79 and 79 %
/// (tests/calibration/blend/earned_spread_test.cc).
///
/// @param past  z must be taken with the sigma as it was before any such factor, or the factor
///              would chase itself. Pairs without a count are ignored.
/// Throws ContractViolation for a negative age. Thread-safe.
[[nodiscard]] EarnedSpread earned_spread(std::span<const PastSpread> past,
                                         const SpreadSettings& settings = {});

}  // namespace slackwater::calibration
