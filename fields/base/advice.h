#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace slackwater {

/// "48.85" of "48,85": what was meant where a number came with a decimal comma; nothing where the
/// text is anything else.
[[nodiscard]] std::optional<std::string> with_decimal_point(std::string_view text);

/// " (did you mean 'forecast'?)" where a known word is near; else empty.
[[nodiscard]] std::string did_you_mean(std::string_view word,
                                       const std::vector<std::string>& known);

}  // namespace slackwater
