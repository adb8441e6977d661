#pragma once
#include <string_view>

namespace slackwater {

/// Where the wind (and the waves) beyond day D come from (fields/docs/conventions.md).
enum class WindPolicy {
  best,      ///< the newest stored forecast, or later analysis, marked as such
  forecast,  ///< only what was published by the issue time
  persist,   ///< the last value of D, decaying to the mean of the known record
};
/// The name in files, rows, JSON and `--wind`.
[[nodiscard]] std::string_view name_of(WindPolicy policy) noexcept;
/// Throws Error(invalid_input) for a name that is none.
[[nodiscard]] WindPolicy wind_policy_from(std::string_view name);

}  // namespace slackwater
