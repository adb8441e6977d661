#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "fields/base/frame.h"
#include "fields/base/time.h"

namespace slackwater::api {

/// A number to four decimals, which is more than a plot shows; null where it is not finite.
[[nodiscard]] nlohmann::json number(double value);
[[nodiscard]] nlohmann::json number(const std::optional<double>& value);
[[nodiscard]] nlohmann::json numbers(const std::vector<double>& values);
/// Milliseconds since 1970.
[[nodiscard]] nlohmann::json times(const std::vector<UtcTime>& values);
/// East and north as two arrays.
[[nodiscard]] nlohmann::json vectors(const std::vector<Horizontal>& values);

/// The text of a JSON value as it may stand inside a script element: no '<', and bytes from outside
/// that are not UTF-8 become U+FFFD rather than an exception.
[[nodiscard]] std::string script_safe(const nlohmann::json& value);

}  // namespace slackwater::api
