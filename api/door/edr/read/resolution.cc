#include "api/door/edr/read/resolution.h"

#include <string>

#include "api/door/edr/read/bad_parameter.h"
#include "api/door/edr/read/number.h"

namespace slackwater::api::edr {

std::optional<std::size_t> parse_resolution(std::string_view parameter, std::string_view text) {
  const auto count = count_of(text);
  if (!count || *count > max_resolution) {
    throw bad_parameter(parameter, text,
                        "a whole number of positions up to " + std::to_string(max_resolution) +
                            ", such as 10, or 0 for the stored resolution");
  }
  return *count == 0 ? std::nullopt : count;
}

std::optional<std::size_t> resolution_in(const QueryString& query, std::string_view key) {
  const auto text = query.find(key);
  return text ? parse_resolution(key, *text) : std::nullopt;
}

}  // namespace slackwater::api::edr
