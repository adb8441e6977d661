#pragma once
#include <string_view>

#include "fields/base/config.h"

namespace slackwater::twin {

/// A time of a mission's YAML: `KEY: 10min`, or in seconds as `KEY_s: 30`; exactly one of them.
/// @throws Error(invalid_input) outside `range`, in seconds
[[nodiscard]] double read_seconds(const Config& config, std::string_view key, Range range);
/// Whether there is one.
[[nodiscard]] bool has_seconds(const Config& config, std::string_view key);

}  // namespace slackwater::twin
