#include "api/dds/message/map_frame.h"

#include <algorithm>

#include "fields/base/error.h"

namespace slackwater::dds {
namespace {

/// The beginning of a client's text, for people.
std::string shown(std::string text) {
  constexpr std::size_t most = 80;
  if (text.size() > most) text.resize(most);
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '.');
  return text;
}

}  // namespace

void expect_map(const char* what, const std::string& frame_id) {
  if (frame_id.empty() || frame_id == "map") return;
  throw Error(ErrorKind::invalid_input, std::string(what) + " is in the frame '" + shown(frame_id) +
                                            "'; give it in `map`: east, north, up of the origin");
}

}  // namespace slackwater::dds
