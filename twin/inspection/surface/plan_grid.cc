#include "twin/inspection/surface/plan_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// A corner of a piece; those of the map's squares are shared.
struct PlanPoint {
  double north_m = 0;
  double east_m = 0;
  std::uint32_t corner = no_patch;
};
using Piece = std::vector<PlanPoint>;
/// Not above 0 inside.
using Bound = std::function<double(double north_m, double east_m)>;

/// Of a square: less is left out, since single precision would not show it.
constexpr double least_piece = 1e-3;

struct Frame {
  double north_m = -std::numeric_limits<double>::infinity();  ///< upper edge
  double south_m = std::numeric_limits<double>::infinity();
  double west_m = std::numeric_limits<double>::infinity();
  double east_m = -std::numeric_limits<double>::infinity();

  void take(double north, double east) {
    north_m = std::max(north_m, north);
    south_m = std::min(south_m, north);
    west_m = std::min(west_m, east);
    east_m = std::max(east_m, east);
  }
};

Frame frame_of(const PlanGrid& grid) {
  Frame frame;
  if (grid.within)
    for (const double side : {-1.0, 1.0})
      frame.take(grid.within->north_m + side * grid.within->radius_m,
                 grid.within->east_m + side * grid.within->radius_m);
  for (const Triple<double>& corner : grid.corners) frame.take(corner.x, corner.y);
  return frame;
}

Bound circle_bound(const PlanCircle& circle, double sign) {
  return [=](double north_m, double east_m) {
    return sign * (std::hypot(north_m - circle.north_m, east_m - circle.east_m) - circle.radius_m);
  };
}

std::vector<Bound> bounds_of(const PlanGrid& grid) {
  std::vector<Bound> bounds;
  if (grid.within) bounds.push_back(circle_bound(*grid.within, 1));
  if (grid.without) bounds.push_back(circle_bound(*grid.without, -1));
  for (std::size_t i = 0; i < grid.corners.size(); ++i) {
    const Triple<double> from = grid.corners[i];
    const Triple<double> way = grid.corners[(i + 1) % grid.corners.size()] - from;
    // To the left of a clockwise edge, seen from above, is outside.
    bounds.emplace_back([=](double north_m, double east_m) {
      return -(way.x * (east_m - from.y) - way.y * (north_m - from.x));
    });
  }
  return bounds;
}

PlanPoint crossing(const Bound& bound, PlanPoint in, PlanPoint out) {
  for (int i = 0; i < 52; ++i) {
    const double north_m = 0.5 * (in.north_m + out.north_m);
    const double east_m = 0.5 * (in.east_m + out.east_m);
    (bound(north_m, east_m) <= 0 ? in : out) = {north_m, east_m};
  }
  return {in.north_m, in.east_m};
}

/// Sutherland and Hodgman (1974), with an edge that may be bent: a chord stands for it.
Piece cut(const Piece& piece, const Bound& bound) {
  Piece kept;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const PlanPoint &from = piece[i], &to = piece[(i + 1) % piece.size()];
    const bool from_in = bound(from.north_m, from.east_m) <= 0;
    const bool to_in = bound(to.north_m, to.east_m) <= 0;
    if (from_in) kept.push_back(from);
    if (from_in && !to_in) kept.push_back(crossing(bound, from, to));
    if (!from_in && to_in) kept.push_back(crossing(bound, to, from));
  }
  return kept;
}

double area_of(const Piece& piece) {
  double twice = 0;
  for (std::size_t i = 0; i < piece.size(); ++i) {
    const PlanPoint &a = piece[i], &b = piece[(i + 1) % piece.size()];
    twice += a.north_m * b.east_m - a.east_m * b.north_m;
  }
  return 0.5 * std::abs(twice);
}

class PlanMaker {
 public:
  PlanMaker(const PlanGrid& grid, double patch_m)
      : grid_(grid),
        bounds_(bounds_of(grid)),
        frame_(frame_of(grid)),
        builder_({0.5 * (frame_.north_m + frame_.south_m), 0.5 * (frame_.west_m + frame_.east_m),
                  grid.z_m(frame_.north_m, frame_.west_m)}) {
    const double wide_m = frame_.east_m - frame_.west_m;
    const double high_m = frame_.north_m - frame_.south_m;
    const double fine = grid.finest_m > 0 ? std::min(std::ceil(patch_m / grid.finest_m), 9.0) : 1;
    constexpr double most_cells = 4.0 * TooManyPatches::most_triangles;
    const double patches = wide_m / patch_m * (high_m / patch_m);
    // A disc fills pi / 4 of its square.
    if (grid.within && 0.78 * patches > TooManyPatches::most_patches) throw TooManyPatches();
    if (patches * fine * fine > most_cells) throw TooManyPatches();
    parts_ = odd_from(fine);
    columns_ = pieces_in(wide_m, patch_m);
    rows_ = pieces_in(high_m, patch_m);
    cell_east_m_ = wide_m / static_cast<double>(columns_ * parts_);
    cell_north_m_ = high_m / static_cast<double>(rows_ * parts_);
    shared_.assign((columns_ * parts_ + 1) * (rows_ * parts_ + 1), no_patch);
  }

  Surface make(SurfaceKind kind) {
    for (std::size_t row = 0; row < rows_; ++row)
      for (std::size_t column = 0; column < columns_; ++column) add_patch(column, row);
    Sheet sheet;
    sheet.width_m = frame_.east_m - frame_.west_m;
    sheet.height_m = frame_.north_m - frame_.south_m;
    sheet.along = "east";
    sheet.down = "south";
    return builder_.finish(kind, sheet);
  }

 private:
  PlanPoint lattice(std::size_t i, std::size_t j) const {
    return {frame_.north_m - cell_north_m_ * static_cast<double>(j),
            frame_.west_m + cell_east_m_ * static_cast<double>(i),
            static_cast<std::uint32_t>(j * (columns_ * parts_ + 1) + i)};
  }
  std::uint32_t corner_of(const PlanPoint& at) {
    const auto add = [&] {
      return builder_.add_corner({at.north_m, at.east_m, grid_.z_m(at.north_m, at.east_m)});
    };
    if (at.corner == no_patch) return add();
    std::uint32_t& shared = shared_[at.corner];
    if (shared == no_patch) shared = add();
    return shared;
  }

  void add_patch(std::size_t column, std::size_t row) {
    struct Cut {
      Piece piece;
      bool is_whole = false;
    };
    std::vector<Cut> cuts;
    Frame box;
    std::size_t triangles = 0;
    for (std::size_t j = row * parts_; j < (row + 1) * parts_; ++j)
      for (std::size_t i = column * parts_; i < (column + 1) * parts_; ++i) {
        Cut cell{{lattice(i, j), lattice(i + 1, j), lattice(i + 1, j + 1), lattice(i, j + 1)}};
        for (const Bound& bound : bounds_) cell.piece = cut(cell.piece, bound);
        const double whole_m2 = cell_east_m_ * cell_north_m_;
        if (cell.piece.size() < 3 || area_of(cell.piece) < least_piece * whole_m2) continue;
        cell.is_whole = area_of(cell.piece) > (1 - 1e-9) * whole_m2;
        for (const PlanPoint& at : cell.piece) box.take(at.north_m, at.east_m);
        triangles += cell.piece.size() - 2;
        cuts.push_back(std::move(cell));
      }
    if (cuts.empty()) return;
    builder_.expect_room(1, triangles);
    const bool is_whole = cuts.size() == parts_ * parts_ &&
                          std::all_of(cuts.begin(), cuts.end(), [](auto& c) { return c.is_whole; });
    // The middle of its middle square, or the middle of its largest triangle.
    double largest_m2 = -1;
    std::array<PlanPoint, 3> centre;
    std::array<std::uint32_t, 3> centre_corners{};
    std::array<double, 3> weights{1.0 / 3, 1.0 / 3, 1.0 / 3};
    std::vector<std::array<std::uint32_t, 3>> made;
    for (std::size_t c = 0; c < cuts.size(); ++c) {
      const Piece& piece = cuts[c].piece;
      std::vector<std::uint32_t> ids;
      for (const PlanPoint& at : piece) ids.push_back(corner_of(at));
      for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
        const double own_m2 = area_of({piece[0], piece[i], piece[i + 1]});
        if (own_m2 < 0.1 * least_piece * cell_east_m_ * cell_north_m_) continue;
        made.push_back({ids[0], ids[i + 1], ids[i]});
        const double m2 = is_whole ? (c == cuts.size() / 2 && i == 1 ? 1 : 0) : own_m2;
        if (m2 <= largest_m2) continue;
        largest_m2 = m2;
        centre = {piece[0], piece[i + 1], piece[i]};
        centre_corners = made.back();
      }
    }
    // Off the diagonal, so that no ray to the centre passes between two triangles.
    if (is_whole) weights = {0.45 + 0.1 / 3, 0.45 + 0.1 / 3, 0.1 / 3};
    double north_m = 0, east_m = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      north_m += weights[i] * centre[i].north_m;
      east_m += weights[i] * centre[i].east_m;
    }
    const std::uint32_t patch =
        builder_.add_patch(east_m - frame_.west_m, frame_.north_m - north_m,
                           box.east_m - box.west_m, box.north_m - box.south_m);
    builder_.put_centre(patch, centre_corners, weights);
    for (const auto& t : made) builder_.add_triangle(t[0], t[1], t[2], patch);
  }

  const PlanGrid& grid_;
  std::vector<Bound> bounds_;
  Frame frame_;
  SurfaceBuilder builder_;
  std::size_t parts_ = 1;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  double cell_east_m_ = 0;
  double cell_north_m_ = 0;
  std::vector<std::uint32_t> shared_;
};

}  // namespace

Surface make_plan(SurfaceKind kind, const PlanGrid& grid, double patch_m) {
  expects(grid.within.has_value() != !grid.corners.empty(), "a plan has one outer edge");
  return PlanMaker(grid, patch_m).make(kind);
}

}  // namespace slackwater::twin
