#pragma once
#include <cstdint>
#include <vector>

#include "api/perception/detection.h"

namespace slackwater::api {

/// Pixels that touch, by side or corner.
struct Piece {
  PixelBox box;
  std::size_t area_px = 0;
  double sum = 0;  ///< of what was asked to be summed over its pixels
};

/// The pieces of a mask, in the order of their first pixels, row by row.
/// @param mask    wide x high, 0: not of any piece
/// @param weight  of each pixel, for `Piece::sum`
[[nodiscard]] std::vector<Piece> pieces_of(const std::vector<std::uint8_t>& mask,
                                           const std::vector<float>& weight, int wide, int high);

}  // namespace slackwater::api
