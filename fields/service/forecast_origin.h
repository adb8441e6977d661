#pragma once
#include <string_view>

namespace slackwater {

/// How a stored forecast came to be.
enum class ForecastOrigin {
  forecast,  ///< the daily job made it, with what was known then
  hindcast,  ///< made over a past period as if live
};
/// The name in files, rows and JSON.
[[nodiscard]] std::string_view name_of(ForecastOrigin origin) noexcept;
/// Throws Error(invalid_input) for a name that is none.
[[nodiscard]] ForecastOrigin forecast_origin_from(std::string_view name);

}  // namespace slackwater
