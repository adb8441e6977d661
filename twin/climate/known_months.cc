#include "twin/climate/known_months.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {

std::vector<int> KnownMonths::unknown() const {
  std::vector<int> found;
  for (int month = 1; month <= 12; ++month)
    if (by_month[static_cast<std::size_t>(month - 1)].known == 0) found.push_back(month);
  return found;
}

std::vector<int> KnownMonths::thin() const {
  std::size_t most = 0;
  for (const KnownSteps& month : by_month) most = std::max(most, month.known);
  std::vector<int> found;
  for (int month = 1; month <= 12; ++month) {
    const std::size_t known = by_month[static_cast<std::size_t>(month - 1)].known;
    if (known > 0 && 2 * known < most) found.push_back(month);
  }
  return found;
}

KnownMonths known_months(std::span<const double> values, const std::vector<MonthSteps>& months) {
  KnownMonths result;
  for (const MonthSteps& part : months) {
    KnownSteps& month = result.by_month[static_cast<std::size_t>(part.month - 1)];
    month.steps += part.steps.steps();
    for (std::size_t i = part.steps.begin; i < part.steps.end; ++i)
      month.known += std::isnan(values[i]) ? 0 : 1;
  }
  for (const KnownSteps& month : result.by_month) {
    result.all.steps += month.steps;
    result.all.known += month.known;
  }
  return result;
}

}  // namespace slackwater::twin
