#pragma once
#include <cstddef>
#include <filesystem>

#include "twin/render/lens/picture.h"

namespace slackwater::api {

/// A PNG or JPEG file as its pixels are stored: a note in it that says which way up it was held
/// (EXIF) is not followed, as labels of data sets are of the stored pixels. Grey pictures become
/// three equal colours, transparency is left out.
/// @throws Error(not_found); Error(invalid_input) for another format, a damaged file, more than
///         `most_pixels`, which is seen before room is made for them
[[nodiscard]] twin::Picture read_picture(const std::filesystem::path& file);

inline constexpr std::size_t most_pixels = 100'000'000;

}  // namespace slackwater::api
