#include "api/edr/path_segments.h"

#include <algorithm>

#include "api/edr/bad_parameter.h"
#include "api/edr/percent_code.h"

namespace slackwater::api::edr {
namespace {

bool is_a_name(const std::string& segment) {
  const auto is_bad = [](char c) {
    return c == '/' || c == '\\' || static_cast<unsigned char>(c) < 0x20 || c == 0x7F;
  };
  return !segment.empty() && segment != "." && segment != ".." &&
         std::none_of(segment.begin(), segment.end(), is_bad);
}

}  // namespace

std::vector<std::string> path_segments(std::string_view path) {
  expect_short("path", path, max_path_bytes);
  const std::string_view whole = path;
  std::vector<std::string> segments;
  if (path.starts_with('/')) path.remove_prefix(1);
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    std::string segment = percent_decoded("path", path.substr(0, end), Plus::is_plus);
    if (!is_a_name(segment)) {
      throw Error(ErrorKind::not_found, "nothing is served at '" + shown(whole) +
                                            "'; the landing page / has links to all that is");
    }
    segments.push_back(std::move(segment));
    path.remove_prefix(std::min(end + 1, path.size()));
  }
  return segments;
}

}  // namespace slackwater::api::edr
