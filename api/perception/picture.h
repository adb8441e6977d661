#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace slackwater::api {

/// What a camera saw: three bytes a pixel (red, green, blue), rows from the top, from the left.
struct Picture {
  int wide = 0;
  int high = 0;
  std::vector<std::uint8_t> rgb;

  [[nodiscard]] const std::uint8_t* at(int column, int row) const noexcept {
    return rgb.data() + 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(wide) +
                             static_cast<std::size_t>(column));
  }
};

/// A PNG or JPEG file as its pixels are stored: a note in it that says which way up it was held
/// (EXIF) is not followed, as labels of data sets are of the stored pixels. Grey pictures become
/// three equal colours, transparency is left out.
/// @throws Error(not_found); Error(invalid_input) for another format, a damaged file, more than
///         `most_pixels`, which is seen before room is made for them
[[nodiscard]] Picture read_picture(const std::filesystem::path& file);

inline constexpr std::size_t most_pixels = 100'000'000;

}  // namespace slackwater::api
