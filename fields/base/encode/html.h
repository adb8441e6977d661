#pragma once
#include <string>
#include <string_view>

namespace slackwater {

/// The text with the five characters that HTML gives a meaning replaced: fit to stand between tags
/// and inside an attribute in quotes of either kind. Not for scripts, styles or addresses.
[[nodiscard]] std::string escaped_html(std::string_view text);

}  // namespace slackwater
