#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "fields/base/config.h"
#include "twin/risk/risk_cause.h"

namespace slackwater::twin {

/// Whom or what a cause harms.
enum class Harmed : std::uint8_t { people, environment, asset, schedule, cost };
inline constexpr std::size_t harmed_count = 5;
[[nodiscard]] std::string_view name_of(Harmed harmed) noexcept;

/// How bad it would be, in classes from 1 (slight) to 5 (grave).
struct Consequence {
  RiskCause cause{};
  std::array<int, harmed_count> grade{1, 1, 1, 1, 1};
  std::string source;
  std::string status;  ///< confirmed, estimate, unconfirmed

  [[nodiscard]] Harmed worst() const noexcept;
  [[nodiscard]] int worst_grade() const noexcept;
};

/// `risks` of a task, one entry a cause:
///
///     risks:
///       - {cause: tether, people: 1, environment: 2, asset: 4, schedule: 4, cost: 3}
///
/// None of the five is left out. @throws Error(invalid_input) also for two of a cause
[[nodiscard]] std::vector<Consequence> read_consequences(const Config& task);

}  // namespace slackwater::twin
