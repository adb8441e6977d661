#pragma once
#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "twin/risk/workability/calendar.h"

namespace slackwater::twin {

/// How much of a time is known.
struct KnownSteps {
  std::size_t steps = 0;
  std::size_t known = 0;
};

/// How much of each month a history knows, all its years together: one without winters is no
/// climate of a year.
struct KnownMonths {
  KnownSteps all;
  std::array<KnownSteps, 12> by_month{};  ///< from January on

  /// 1 to 12, of which nothing at all is known, the history being shorter or full of gaps.
  [[nodiscard]] std::vector<int> unknown() const;
  /// Known by less than half as many steps as the best known month, but not unknown.
  [[nodiscard]] std::vector<int> thin() const;
};

/// @param values  one a step, NaN where nobody knows  @param months  those of all steps
[[nodiscard]] KnownMonths known_months(std::span<const double> values,
                                       const std::vector<MonthSteps>& months);

}  // namespace slackwater::twin
