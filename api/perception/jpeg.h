#pragma once
#include <cstdint>
#include <vector>

#include "twin/render/lens/picture.h"

namespace slackwater::api {

/// A picture as a JPEG file (ITU-T T.81, 4:2:0), for people and for wires that whole pixels are too
/// much for. By the library's exact integer transform: the same bytes on every machine.
///
/// @param quality  1 to 100; at the default a 640 x 360 picture under water takes some 20 kB
/// @throws Error(internal) where the library has no room
[[nodiscard]] std::vector<std::uint8_t> jpeg_of(const twin::Picture& picture, int quality = 85);

}  // namespace slackwater::api
