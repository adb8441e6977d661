#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace slackwater {

/// Of 0-9, a-f, A-F; -1: it is none of them.
[[nodiscard]] int hexadecimal_digit(char c) noexcept;

/// Decodes %XX once; nothing where a '%' is not followed by two hexadecimal digits.
[[nodiscard]] std::optional<std::string> percent_decoded(std::string_view text);

/// All but the unreserved characters of RFC 3986 encoded: fit for a path segment, a
/// query value or a header.
[[nodiscard]] std::string percent_encoded(std::string_view text);

}  // namespace slackwater
