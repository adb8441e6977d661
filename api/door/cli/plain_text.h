#pragma once
#include <string>
#include <string_view>

namespace slackwater::api {

/// Text as a terminal may have it, whoever named what stands in it: valid UTF-8, and no character
/// that steers but ends of lines and tabs. Others stand as they are written in JSON, `\u001b`;
/// bytes that are no UTF-8 as `\xff`. The beginning of a character waits for the rest of it, which
/// may come with the next piece.
class PlainText {
 public:
  /// The next piece of it.
  [[nodiscard]] std::string next(std::string_view piece);

 private:
  std::string begun_;
};

}  // namespace slackwater::api
