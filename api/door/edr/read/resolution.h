#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

#include "api/door/edr/read/query_string.h"

namespace slackwater::api::edr {

constexpr std::size_t max_resolution = 1'000;

/// Reads `resolution-x`, `-y` or `-z`: the number of positions along an axis, its two ends
/// included; nothing for 0, which asks for the stored resolution (/req/edr/resolution-x-response).
/// Throws Error(usage) for anything but a whole number up to max_resolution.
[[nodiscard]] std::optional<std::size_t> parse_resolution(std::string_view parameter,
                                                          std::string_view text);

/// The same of a query; nothing where it has none.
[[nodiscard]] std::optional<std::size_t> resolution_in(const QueryString& query,
                                                       std::string_view key);

}  // namespace slackwater::api::edr
