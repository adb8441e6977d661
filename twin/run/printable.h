#pragma once
#include <algorithm>
#include <string>
#include <string_view>

namespace slackwater::twin {

/// A stranger's text as records and answers have it: letters that every file can hold, the others
/// as '?', and not without end.
[[nodiscard]] inline std::string printable(std::string_view text, std::size_t longest = 200) {
  std::string out(text.substr(0, longest));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return out;
}

}  // namespace slackwater::twin
