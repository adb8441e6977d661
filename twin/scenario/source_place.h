#pragma once
#include <string>
#include <string_view>

#include "fields/base/config.h"

namespace slackwater::twin {

/// "FILE:LINE" that something was read from, for what is found amiss with it once more is known.
/// Says where, not what: all places are equal.
struct SourcePlace {
  std::string text;
  bool operator==(const SourcePlace&) const noexcept { return true; }
};

/// @throws Error(invalid_input) with the place before it, always
[[noreturn]] void refuse_at(const SourcePlace& place, const std::string& why);

/// Where a key of this mapping stands, which alone has it. @param key  with a dot before it
[[nodiscard]] SourcePlace place_of_key(const Config& config, std::string_view key);

}  // namespace slackwater::twin
