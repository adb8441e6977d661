#pragma once
#include <optional>
#include <vector>

#include "twin/handling/replayed.h"

namespace slackwater::twin {

/// How far ours was from a trial in one measured column: ours less theirs, angles the short way
/// round. Over the rows that have a value and that our run came to, but the first, where ours
/// begins. SI.
struct TrialError {
  TrialQuantity quantity{};
  std::size_t n = 0;            ///< values; 0: there are none, and the errors are 0
  double rms = 0;               ///< root mean square
  double bias = 0;              ///< mean
  double largest = 0;           ///< of its size
  double range = 0;             ///< greatest less least of theirs; of angles unwound
  std::optional<double> share;  ///< rms as a share of that range; nothing: they never change
};

/// Where both were last, of a trial that measured north and east.
struct TrialPlace {
  double at_s = 0;   ///< of the trial's clock
  double off_m = 0;  ///< ours from theirs
  double way_m = 0;  ///< theirs until then, from value to value: noise of a receiver adds to it
  std::optional<double> share;  ///< off as a share of the way; nothing: they never moved
};

struct TrialErrors {
  std::vector<TrialError> error;  ///< one a measured column, in the trial's order
  std::optional<TrialPlace> place;
};

[[nodiscard]] TrialErrors errors_of(const Trial& trial, const TrialRun& run);

/// Ours less theirs of one quantity; an angle the short way round.
[[nodiscard]] double off_by(TrialQuantity quantity, double ours, double theirs) noexcept;
/// Greatest less least value of a column, all rows; an angle unwound from row to row.
[[nodiscard]] double range_of(const TrialColumn& column) noexcept;

}  // namespace slackwater::twin
