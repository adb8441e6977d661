#include "api/door/edr/read/parameter_names.h"

#include <algorithm>
#include <unordered_map>

#include "api/door/edr/read/bad_parameter.h"
#include "fields/base/config.h"

namespace slackwater::api::edr {
namespace {

constexpr std::size_t max_bytes = std::size_t{64} * 1024;
/// A longer name is not compared with the known ones, which would take its length times theirs.
constexpr std::size_t max_name_bytes = 128;
/// So many known names may a message list.
constexpr std::size_t max_listed = 12;

std::string_view trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

std::string some_of(const std::vector<std::string>& known) {
  std::string list;
  for (std::size_t i = 0; i < std::min(known.size(), max_listed); ++i) {
    list += (i == 0 ? "" : ", ") + known[i];
  }
  return known.size() > max_listed ? list + ", ..." : list;
}

[[noreturn]] void refuse(std::string_view name, const std::vector<std::string>& known) {
  if (!name.empty() && name.size() <= max_name_bytes) {
    if (const auto nearest = nearest_word(name, known)) {
      throw bad_parameter("parameter-name", name,
                          "a parameter of this collection; did you mean '" + *nearest + "'?");
    }
  }
  throw bad_parameter("parameter-name", name,
                      "parameters of this collection, separated by commas: " + some_of(known));
}

}  // namespace

std::vector<std::size_t> parse_parameter_names(std::string_view text,
                                               const std::vector<std::string>& known) {
  expect_short("parameter-name", text, max_bytes);
  if (static_cast<std::size_t>(std::count(text.begin(), text.end(), ',')) >= max_parameter_names) {
    throw bad_parameter("parameter-name", text,
                        "at most " + std::to_string(max_parameter_names) + " names");
  }
  std::unordered_map<std::string_view, std::size_t> places;
  for (std::size_t i = 0; i < known.size(); ++i) places.emplace(known[i], i);
  std::vector<std::size_t> asked;
  std::vector<bool> is_asked(known.size(), false);
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find(',', start), text.size());
    const std::string_view name = trimmed(text.substr(start, end - start));
    const auto place = places.find(name);
    if (place == places.end()) refuse(name, known);
    if (!is_asked[place->second]) asked.push_back(place->second);
    is_asked[place->second] = true;
    start = end + 1;
  }
  return asked;
}

}  // namespace slackwater::api::edr
