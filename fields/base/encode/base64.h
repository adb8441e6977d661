#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace slackwater {

/// Bytes as text, RFC 4648 section 4, filled up with '='.
[[nodiscard]] std::string base64_of(std::span<const std::uint8_t> bytes);

}  // namespace slackwater
