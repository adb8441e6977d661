#include "fields/base/encode/utf8.h"

#include <algorithm>

namespace slackwater {
namespace {

std::uint32_t byte_of(std::string_view text, std::size_t i) {
  return static_cast<unsigned char>(text[i]);
}

/// How long a character is that begins so; 0: none does.
std::size_t bytes_from(std::uint32_t first) {
  if (first < 0x80) return 1;
  if (first < 0xc2 || first > 0xf4) return 0;
  return first < 0xe0 ? 2 : first < 0xf0 ? 3 : 4;
}

/// What may follow: neither overlong, nor a surrogate, nor beyond U+10FFFF.
bool may_follow(std::uint32_t first, std::size_t place, std::uint32_t byte) {
  if (place > 1) return (byte & 0xc0U) == 0x80;
  const std::uint32_t least = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
  const std::uint32_t most = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
  return byte >= least && byte <= most;
}

/// How many of its first bytes are those of one character.
std::size_t sound_bytes(std::string_view text) {
  const std::size_t bytes = text.empty() ? 0 : bytes_from(byte_of(text, 0));
  std::size_t sound = bytes == 0 ? 0 : 1;
  while (sound < std::min(bytes, text.size()) &&
         may_follow(byte_of(text, 0), sound, byte_of(text, sound)))
    ++sound;
  return sound;
}

}  // namespace

std::optional<std::uint32_t> take_character(std::string_view& text) {
  const std::size_t bytes = sound_bytes(text);
  if (bytes == 0 || bytes < bytes_from(byte_of(text, 0))) return std::nullopt;
  const std::uint32_t first = byte_of(text, 0);
  std::uint32_t character = bytes == 1 ? first : first & (0x7fU >> bytes);
  for (std::size_t i = 1; i < bytes; ++i) character = character << 6U | (byte_of(text, i) & 0x3fU);
  text.remove_prefix(bytes);
  return character;
}

bool is_begun_character(std::string_view text) {
  const std::size_t sound = sound_bytes(text);
  return sound > 0 && sound == text.size() && sound < bytes_from(byte_of(text, 0));
}

std::string as_utf8(std::string_view text) {
  std::string utf8;
  utf8.reserve(text.size());
  for (std::string_view left = text; !left.empty();) {
    const std::string_view from = left;
    if (take_character(left)) {
      utf8 += from.substr(0, from.size() - left.size());
    } else {
      utf8 += "\xef\xbf\xbd";
      left.remove_prefix(1);
    }
  }
  return utf8;
}

bool steers(std::uint32_t character) {
  const auto is_in = [character](std::uint32_t first, std::uint32_t last) {
    return character >= first && character <= last;
  };
  return is_in(0, 0x1f) || is_in(0x7f, 0x9f) || character == 0x61c || is_in(0x200e, 0x200f) ||
         is_in(0x2028, 0x202e) || is_in(0x2066, 0x2069);
}

}  // namespace slackwater
