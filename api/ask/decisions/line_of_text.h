#pragma once
#include <cstddef>
#include <string>
#include <string_view>

namespace slackwater::api {

/// A line that a person wrote, without what is blank at its ends: UTF-8 of so many characters at
/// most, none of which moves a cursor, ends a line or turns the direction of writing (Unicode
/// categories Cc, Zl, Zp and the bidirectional controls U+200E, U+200F, U+202A to U+202E, U+2066 to
/// U+2069): what a terminal or a page shows is what was written.
/// @param what  for messages: "--by"  @throws Error(usage)
[[nodiscard]] std::string line_of_text(std::string_view what, std::string_view text,
                                       std::size_t most_characters);

}  // namespace slackwater::api
