#pragma once
#include <string>
#include <string_view>

namespace slackwater::ingest {

/// ASCII lower case.
[[nodiscard]] std::string lower_case(std::string_view text);
/// Whether `text` holds `part`, letter case ignored.
[[nodiscard]] bool contains_ignoring_case(std::string_view text, std::string_view part);

}  // namespace slackwater::ingest
