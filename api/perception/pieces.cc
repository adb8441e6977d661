#include "api/perception/pieces.h"

#include <algorithm>

namespace slackwater::api {

std::vector<Piece> pieces_of(const std::vector<std::uint8_t>& mask,
                             const std::vector<float>& weight, int wide, int high) {
  std::vector<std::uint8_t> left = mask;
  std::vector<Piece> pieces;
  std::vector<int> waiting;
  for (int first = 0; first < wide * high; ++first) {
    if (left[static_cast<std::size_t>(first)] == 0) continue;
    Piece piece{{static_cast<double>(wide), static_cast<double>(high), 0, 0}, 0, 0};
    left[static_cast<std::size_t>(first)] = 0;
    waiting.assign(1, first);
    while (!waiting.empty()) {
      const int at = waiting.back();
      waiting.pop_back();
      const int column = at % wide, row = at / wide;
      piece.box.left = std::min<double>(piece.box.left, column);
      piece.box.top = std::min<double>(piece.box.top, row);
      piece.box.right = std::max<double>(piece.box.right, column + 1);
      piece.box.bottom = std::max<double>(piece.box.bottom, row + 1);
      ++piece.area_px;
      piece.sum += static_cast<double>(weight[static_cast<std::size_t>(at)]);
      for (int r = std::max(0, row - 1); r <= std::min(high - 1, row + 1); ++r) {
        for (int c = std::max(0, column - 1); c <= std::min(wide - 1, column + 1); ++c) {
          std::uint8_t& beside = left[static_cast<std::size_t>(r * wide + c)];
          if (beside == 0) continue;
          beside = 0;
          waiting.push_back(r * wide + c);
        }
      }
    }
    pieces.push_back(piece);
  }
  return pieces;
}

}  // namespace slackwater::api
