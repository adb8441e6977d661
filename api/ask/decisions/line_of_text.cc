#include "api/ask/decisions/line_of_text.h"

#include <cstdint>
#include <optional>

#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

/// The next character of UTF-8 (RFC 3629), taken off the text; nothing where it is none.
std::optional<std::uint32_t> take_character(std::string_view& text) {
  const auto byte = [&](std::size_t i) {
    return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i]));
  };
  const std::uint32_t first = byte(0);
  const std::size_t bytes = first < 0x80 ? 1 : first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
  if ((first >= 0x80 && first < 0xc2) || first > 0xf4 || text.size() < bytes) return std::nullopt;
  std::uint32_t character = bytes == 1 ? first : first & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) {
    if ((byte(i) & 0xc0U) != 0x80) return std::nullopt;
    character = character << 6U | (byte(i) & 0x3fU);
  }
  const bool is_overlong = (bytes == 3 && character < 0x800) || (bytes == 4 && character < 0x10000);
  const bool is_surrogate = character >= 0xd800 && character <= 0xdfff;
  if (is_overlong || is_surrogate || character > 0x10ffff) return std::nullopt;
  text.remove_prefix(bytes);
  return character;
}

bool steers(std::uint32_t c) {
  const auto is_in = [c](std::uint32_t first, std::uint32_t last) {
    return c >= first && c <= last;
  };
  return is_in(0, 0x1f) || is_in(0x7f, 0x9f) || is_in(0x200e, 0x200f) || is_in(0x2028, 0x202e) ||
         is_in(0x2066, 0x2069);
}

}  // namespace

std::string line_of_text(std::string_view what, std::string_view text,
                         std::size_t most_characters) {
  const std::string_view line = trimmed(text);
  const std::string head = std::string(what) + ": found ";
  std::size_t characters = 0;
  for (std::string_view left = line; !left.empty(); ++characters) {
    const auto character = take_character(left);
    if (!character)
      throw Error(ErrorKind::usage,
                  head + formatted("bytes that are no UTF-8 after {} characters, expected text in "
                                   "UTF-8; write it in a terminal whose locale is UTF-8",
                                   characters));
    if (steers(*character))
      throw Error(ErrorKind::usage,
                  head + formatted("the control character U+{:04X} after {} characters, expected "
                                   "one plain line; leave it out",
                                   *character, characters));
  }
  if (characters > most_characters)
    throw Error(ErrorKind::usage, head + formatted("{} characters, expected at most {}; shorten it",
                                                   characters, most_characters));
  return std::string(line);
}

}  // namespace slackwater::api
