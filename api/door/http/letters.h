#pragma once
#include <string_view>

// Only sources of this folder include this.

namespace slackwater::api::http::letters {

inline bool is_space(char letter) { return letter == ' ' || letter == '\t'; }
inline bool is_end_of_line(char letter) { return letter == '\r' || letter == '\n'; }
/// To be seen, and of ASCII.
inline bool is_plain(char letter) { return letter > ' ' && letter < '\x7f'; }
inline bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }
inline bool is_letter(char letter) {
  const char small = static_cast<char>(letter | 0x20);
  return small >= 'a' && small <= 'z';
}
/// Of a name of a field (RFC 9110 §5.6.2).
inline bool is_of_name(char letter) {
  return is_letter(letter) || is_digit(letter) ||
         std::string_view("!#$%&'*+-.^_`|~").find(letter) != std::string_view::npos;
}
/// Of a host with its port, in the target of a request to a proxy.
inline bool is_of_host(char letter) {
  return is_letter(letter) || is_digit(letter) ||
         std::string_view("-._~:[]%").find(letter) != std::string_view::npos;
}

}  // namespace slackwater::api::http::letters
