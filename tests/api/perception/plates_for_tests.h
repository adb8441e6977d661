#pragma once
#include <array>
#include <cstdint>
#include <filesystem>

#include "api/perception/read_picture.h"

// Plates with known things on them.

namespace slackwater::tests {

using Colour = std::array<std::uint8_t, 3>;

inline constexpr Colour steel{150, 155, 160};
inline constexpr Colour rust{150, 80, 30};

[[nodiscard]] twin::Picture plate(int wide, int high, const Colour& colour = steel);
/// Columns from `left` up to and without `right`, rows likewise.
void paint(twin::Picture& picture, int left, int top, int right, int bottom, const Colour& colour);

/// By zlib, after the standard's text: not by the library that reads it.
void write_png(const std::filesystem::path& file, const twin::Picture& picture);
/// With so little loss that a plain colour is right to a level or two.
void write_jpeg(const std::filesystem::path& file, const twin::Picture& picture);

}  // namespace slackwater::tests
