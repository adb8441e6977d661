#pragma once
#include <cmath>
#include <nlohmann/json.hpp>

namespace slackwater::people {

/// A number as it is told: so that what hardly changes is not told again, and with no more digits
/// than it needs. Null: it is none. @param to  a step
[[nodiscard]] inline nlohmann::json rounded(double value, double to) {
  if (!std::isfinite(value)) return nullptr;
  const double steps = 1 / to;  // 0.41, and not 41 times 0.01
  return (to < 1 ? std::round(value * steps) / steps : std::round(value / to) * to) + 0.0;
}

}  // namespace slackwater::people
