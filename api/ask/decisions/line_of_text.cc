#include "api/ask/decisions/line_of_text.h"

#include "fields/base/encode/utf8.h"
#include "fields/base/error.h"
#include "fields/base/text.h"

namespace slackwater::api {

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
