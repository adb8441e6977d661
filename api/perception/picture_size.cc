#include "api/perception/picture_size.h"

#include <algorithm>
#include <array>

namespace slackwater::api {
namespace {

std::uint32_t big_endian(std::span<const std::uint8_t> bytes) noexcept {
  std::uint32_t value = 0;
  for (const std::uint8_t byte : bytes) value = value << 8U | byte;
  return value;
}

std::optional<PictureSize> of_png(std::span<const std::uint8_t> file) noexcept {
  constexpr std::array<std::uint8_t, 8> begin{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  constexpr std::array<std::uint8_t, 4> head{'I', 'H', 'D', 'R'};
  if (file.size() < 24 || !std::equal(begin.begin(), begin.end(), file.begin()) ||
      !std::equal(head.begin(), head.end(), file.begin() + 12))
    return std::nullopt;
  return PictureSize{big_endian(file.subspan(16, 4)), big_endian(file.subspan(20, 4))};
}

/// Start of frame: 0xC0 to 0xCF but for tables of Huffman and arithmetic codes (C4, CC) and C8.
bool is_frame(std::uint8_t marker) noexcept {
  return marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
}

std::optional<PictureSize> of_jpeg(std::span<const std::uint8_t> file) noexcept {
  if (file.size() < 2 || file[0] != 0xff || file[1] != 0xd8) return std::nullopt;
  std::size_t at = 2;
  while (at + 9 <= file.size()) {
    if (file[at] != 0xff) return std::nullopt;
    const std::uint8_t marker = file[at + 1];
    if (marker == 0xff) {  // one byte of filling
      ++at;
      continue;
    }
    if (is_frame(marker))
      return PictureSize{big_endian(file.subspan(at + 7, 2)), big_endian(file.subspan(at + 5, 2))};
    at += 2 + big_endian(file.subspan(at + 2, 2));
  }
  return std::nullopt;
}

}  // namespace

std::optional<PictureSize> stated_size(std::span<const std::uint8_t> file) noexcept {
  const auto png = of_png(file);
  return png ? png : of_jpeg(file);
}

}  // namespace slackwater::api
