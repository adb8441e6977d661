#pragma once
#include <string>
#include <vector>

#include "fields/base/config.h"

namespace slackwater::twin {

/// Mean and scatter of forecast minus observed significant wave height.
struct HeightError {
  double bias_m = 0;
  double sigma_m = 0;
};

/// What is known of the errors of forecast wave heights, by height and lead. Linear between its
/// heights and leads, at its ends as there; below the first height in proportion to it.
struct HeightErrors {
  std::string name;
  std::string source;
  std::string status;
  std::vector<double> leads_h;                      ///< ascending
  std::vector<double> heights_m;                    ///< ascending
  std::vector<std::vector<HeightError>> by_height;  ///< heights x leads

  [[nodiscard]] HeightError at(double height_m, double lead_h) const noexcept;
};

/// A file of data/alpha:
///
///     leads_h: [12, 24]
///     heights:
///       - {height_m: 1, bias_m: [0.24, 0.26], sigma_m: [0.34, 0.36]}
///
/// @throws Error(invalid_input) with file and line
[[nodiscard]] HeightErrors read_height_errors(const Config& config);

/// How the wave heights of own forecasts erred, over some leads.
struct VerifiedHeights {
  double from_h = 0;  ///< (from, to] of the lead
  double to_h = 24;
  std::size_t forecasts = 0;
  std::size_t pairs = 0;  ///< hours of all of them
  double bias_m = 0;      ///< forecast minus truth
  double sigma_m = 0;
  double mean_height_m = 0;  ///< of the truth
};

/// From how many forecasts on the errors of some leads stand in the place of the published ones.
inline constexpr std::size_t enough_forecasts = 20;

/// The published errors brought to what own forecasts had, lead by lead: at the leads of which
/// enough forecasts were verified deviations are multiplied, and biases moved, so that at the mean
/// height of those forecasts they are theirs. How errors change with the height stays as published:
/// verification does not tell.
[[nodiscard]] HeightErrors with_verified(HeightErrors published,
                                         const std::vector<VerifiedHeights>& verified);

/// The factor alpha that a forecast with such errors wants at a limit, by the published method of
/// the standard's table: the height that the largest of n waves surpasses with probability 1e-4, if
/// the significant height is the limit, over the same if it is the limit but for the error,
///
///   P(largest > h | Hs) = 1 - (1 - exp(-2 (h / Hs)^2))^n        (Rayleigh)
///   Hs = limit - c bias + sigma Z,   Z standard normal,         c = 1/2 of a bias above 0, else 1
///
/// so that a forecast of alpha x limit is as safe as a sea of the limit that one knows. n = 1000
/// waves, some three hours, reproduce 18 of the 20 factors of DNV-OS-H101 table 4-1 within 0.02
/// and all within 0.025 from the errors that it was made of: see the tests.
///
/// @param limit_m  more than 0
/// @return in (0, 1]
/// Cost: some hundred thousand exponentials.
/// Source: twin/docs/operations.md, section 4 (Wilcken 2012).
[[nodiscard]] double alpha_by_errors(double limit_m, const HeightError& error);

}  // namespace slackwater::twin
