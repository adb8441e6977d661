#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace slackwater {

/// The next character of UTF-8 (RFC 3629), taken off the text; nothing where its beginning is none.
[[nodiscard]] std::optional<std::uint32_t> take_character(std::string_view& text);

/// Whether a text is what a character begins with, and more of it is to come.
[[nodiscard]] bool is_begun_character(std::string_view text);

/// The text, each byte of which that is no UTF-8 is U+FFFD.
[[nodiscard]] std::string as_utf8(std::string_view text);

/// Whether a character steers what shows it: control characters (C0, DEL, C1), ends of lines and
/// paragraphs, and what turns the direction of writing (Unicode 15, Bidi_Control).
[[nodiscard]] bool steers(std::uint32_t character);

}  // namespace slackwater
