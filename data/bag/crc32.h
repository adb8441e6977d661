#pragma once
#include <cstdint>
#include <span>

namespace slackwater::bag {

/// CRC-32 of ISO 3309 (polynomial 0xEDB88320, reflected), as MCAP and zlib have it.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint8_t> bytes);

}  // namespace slackwater::bag
