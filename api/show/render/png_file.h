#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

namespace slackwater::api {

/// Writes a PNG of 8 bits: 1 (grey) or 3 (red, green, blue) values a pixel, row by row. The same
/// pixels are the same bytes: no time and no name is in it. Whole or not at all.
/// @throws Error(unavailable) where it cannot be written
void write_png(const std::filesystem::path& file, int wide, int high, int values_of_pixel,
               std::span<const std::uint8_t> values);

}  // namespace slackwater::api
