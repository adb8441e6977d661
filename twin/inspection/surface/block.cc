#include "twin/inspection/surface/block.h"

#include <cmath>
#include <map>

namespace slackwater::twin {
namespace {

using Place = std::array<int, 3>;  // on the lattice of the block's corners

/// A face: where on the lattice it begins, and the ways to the right and down as seen from outside.
struct Face {
  Place begin;  ///< 0 or 1 of each axis: the near or the far end
  std::size_t right_axis;
  int right;
  std::size_t down_axis;
  int down;
};
// Ahead 0, right 1, down 2. To the right and down, as one sees it, turn inward by the right hand.
constexpr std::array<Face, 6> faces{{{{1, 1, 0}, 1, -1, 2, 1},
                                     {{0, 0, 0}, 1, 1, 2, 1},
                                     {{0, 1, 0}, 0, 1, 2, 1},
                                     {{1, 0, 0}, 0, -1, 2, 1},
                                     {{1, 1, 1}, 1, -1, 0, -1},
                                     {{1, 0, 0}, 1, 1, 0, -1}}};

/// A little off the diagonal, so that no ray to the centre passes between two triangles.
constexpr double off_diagonal = 0.1;

}  // namespace

void add_block(SurfaceBuilder& builder, const Block& block) {
  const std::array<double, 3> size_m{block.size_m.x, block.size_m.y, block.size_m.z};
  std::array<int, 3> pieces{};
  std::array<double, 3> n{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    n[axis] = static_cast<double>(pieces_in(size_m[axis], block.patch_m));
    if (n[axis] > static_cast<double>(TooManyPatches::most_patches)) throw TooManyPatches();
    pieces[axis] = static_cast<int>(n[axis]);
  }
  const double cells = 2 * (n[0] * n[1] + n[1] * n[2] + n[2] * n[0]);
  if (cells > static_cast<double>(TooManyPatches::most_triangles)) throw TooManyPatches();
  builder.expect_room(0, 2 * static_cast<std::size_t>(cells));
  std::map<Place, std::uint32_t> corners;
  const auto corner = [&](const Place& p) {
    const auto [found, is_new] = corners.try_emplace(p, 0);
    if (is_new)
      found->second = builder.add_corner(
          block.at(2 * p[0] / n[0] - 1, 2 * p[1] / n[1] - 1, 2 * p[2] / n[2] - 1));
    return found->second;
  };
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const Face& face = faces[f];
    const auto& sheet = block.faces[f];
    const int columns = pieces[face.right_axis], rows = pieces[face.down_axis];
    const double width_m = size_m[face.right_axis] / columns;
    const double height_m = size_m[face.down_axis] / rows;
    if (sheet) builder.expect_room(static_cast<std::size_t>(columns * rows), 0);
    const auto at = [&](int column, int row) {
      Place p{face.begin[0] * pieces[0], face.begin[1] * pieces[1], face.begin[2] * pieces[2]};
      p[face.right_axis] += face.right * column;
      p[face.down_axis] += face.down * row;
      return corner(p);
    };
    for (int row = 0; row < rows; ++row)
      for (int column = 0; column < columns; ++column) {
        const std::uint32_t a = at(column, row), b = at(column + 1, row);
        const std::uint32_t c = at(column + 1, row + 1), d = at(column, row + 1);
        std::uint32_t patch = no_patch;
        if (sheet) {
          const double aside = off_diagonal / 6, end = (1 - off_diagonal) / 2 + off_diagonal / 3;
          patch =
              builder.add_patch(sheet->left_m + (column + 0.5 - aside) * width_m,
                                sheet->top_m + (row + 0.5 + aside) * height_m, width_m, height_m);
          builder.put_centre(patch, {a, c, d}, {end, end, off_diagonal / 3});
        }
        // Down and then to the right turn outward.
        builder.add_triangle(a, c, b, patch);
        builder.add_triangle(a, d, c, patch);
      }
  }
}

std::function<Triple<double>(double, double, double)> box_at(const Triple<double>& middle_m,
                                                             const Triple<double>& ahead,
                                                             const Triple<double>& right,
                                                             const Triple<double>& size_m) {
  const Triple<double> x = (0.5 * size_m.x) * ahead, y = (0.5 * size_m.y) * right;
  const Triple<double> z = (0.5 * size_m.z) * cross(ahead, right);
  return [=](double u, double v, double w) { return middle_m + u * x + v * y + w * z; };
}

}  // namespace slackwater::twin
