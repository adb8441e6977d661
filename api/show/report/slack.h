#pragma once
#include <optional>
#include <vector>

#include "fields/base/time.h"

namespace slackwater::api {

/// A time in which the current stays below a threshold.
struct SlackWindow {
  UtcTime from{};
  UtcTime to{};
  bool is_cut_before = false;  ///< it was below when the series began: the beginning is not known
  bool is_cut_after = false;   ///< it is still below when the series ends
  /// The longest part of it throughout which nine of ten futures stay below; nothing where there is
  /// none.
  std::optional<UtcTime> sure_from;
  std::optional<UtcTime> sure_to;
};

/// Windows in which the likely speed (its median) stays below the threshold, crossings found
/// linearly between the times. A missing value (NaN) ends a window.
/// @param time       ascending
/// @param likely_m_s median, per time
/// @param futures_m_s  the speed in each future, per time; fewer than ten are sure of nothing
/// Throws ContractViolation where the arrays do not fit.
[[nodiscard]] std::vector<SlackWindow> slack_windows(
    const std::vector<UtcTime>& time, const std::vector<double>& likely_m_s,
    const std::vector<std::vector<double>>& futures_m_s, double below_m_s);

}  // namespace slackwater::api
