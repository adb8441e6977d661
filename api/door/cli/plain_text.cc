#include "api/door/cli/plain_text.h"

#include <algorithm>

#include "fields/base/encode/utf8.h"
#include "fields/base/text.h"

namespace slackwater::api {
namespace {

bool is_plain_byte(char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\t'; }

/// Moves what is plain beyond doubt from the beginning of `left` to the end of `plain`.
void move_plain_bytes(std::string_view& left, std::string& plain) {
  const auto* const end = std::find_if_not(left.begin(), left.end(), is_plain_byte);
  const auto bytes = static_cast<std::size_t>(end - left.begin());
  plain += left.substr(0, bytes);
  left.remove_prefix(bytes);
}

/// The next character, or a byte that is of none.
void move_character(std::string_view& left, std::string& plain) {
  const std::string_view before = left;
  const auto character = take_character(left);
  if (!character) {
    plain += formatted("\\x{:02x}", static_cast<unsigned>(static_cast<unsigned char>(left[0])));
    left.remove_prefix(1);
  } else if (steers(*character)) {
    plain += formatted("\\u{:04x}", *character);
  } else {
    plain += before.substr(0, before.size() - left.size());
  }
}

}  // namespace

std::string PlainText::next(std::string_view piece) {
  begun_ += piece;
  std::string_view left = begun_;
  std::string plain;
  plain.reserve(left.size());
  for (move_plain_bytes(left, plain); !left.empty() && !is_begun_character(left);
       move_plain_bytes(left, plain))
    move_character(left, plain);
  begun_ = std::string(left);
  return plain;
}

}  // namespace slackwater::api
