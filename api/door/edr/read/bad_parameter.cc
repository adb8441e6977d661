#include "api/door/edr/read/bad_parameter.h"

namespace slackwater::api::edr {

std::string shown(std::string_view text) {
  std::string printable(text.substr(0, shown_bytes));
  for (char& c : printable) {
    if (c < ' ' || c > '~') c = '.';
  }
  return text.size() > shown_bytes ? printable + "..." : printable;
}

Error bad_parameter(std::string_view name, std::string_view found, std::string_view expected,
                    SourcePlace where) {
  return {ErrorKind::usage,
          std::string(name) + ": found '" + shown(found) + "'; expected " + std::string(expected),
          where};
}

void expect_short(std::string_view name, std::string_view text, std::size_t limit) {
  if (text.size() <= limit) return;
  throw bad_parameter(name, text,
                      "at most " + std::to_string(limit) + " bytes, not " +
                          std::to_string(text.size()) + "; ask for less at a time");
}

}  // namespace slackwater::api::edr
