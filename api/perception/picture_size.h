#pragma once
#include <cstdint>
#include <optional>
#include <span>

namespace slackwater::api {

struct PictureSize {
  std::uint32_t wide = 0;
  std::uint32_t high = 0;
};

/// What a PNG or JPEG file says of its own size; nothing where it is neither, or its head is cut.
/// Source: PNG, ISO/IEC 15948:2004, 11.2.2; JPEG, ITU-T T.81, B.2.2.
[[nodiscard]] std::optional<PictureSize> stated_size(std::span<const std::uint8_t> file) noexcept;

}  // namespace slackwater::api
