#pragma once
#include <cstddef>
#include <optional>
#include <string_view>

namespace slackwater::api::edr {

/// The decimal number at the start of a text, which loses it: sign, digits, point, exponent.
/// Nothing (and the text keeps all) where there is none, where it is not finite, or written as
/// nan, inf or in hexadecimal.
[[nodiscard]] std::optional<double> take_number(std::string_view& text) noexcept;

/// A text that is one such number and nothing else.
[[nodiscard]] std::optional<double> number_of(std::string_view text) noexcept;

/// A text that is a whole number of digits alone, at most nine of them.
[[nodiscard]] std::optional<std::size_t> count_of(std::string_view text) noexcept;

}  // namespace slackwater::api::edr
