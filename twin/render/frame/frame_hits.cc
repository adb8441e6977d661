#include "twin/render/frame/frame_hits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "fields/base/parallel.h"
#include "twin/inspection/cast/triangle_range.h"

namespace slackwater::twin {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
constexpr double most_slack = 0x1p-20;  // of a corner's weight: beyond, a triangle is edge-on
constexpr double near_m = 1e-3;         // triangles are cut there before they are projected
constexpr double spare_pixels = 0.01;   // beyond all that projecting rounds

/// Pixels from first to last, both within; none where first is after last.
struct PixelBox {
  std::uint16_t first_u = 1, last_u = 0;
  std::uint16_t first_v = 1, last_v = 0;

  [[nodiscard]] bool is_empty() const noexcept { return first_u > last_u || first_v > last_v; }
};

/// A place as the camera has it: to the right, down and ahead.
struct Seen {
  double x = 0, y = 0, z = 0;
};

Seen seen_by(const Pinhole& camera, const Triple<double>& way) noexcept {
  return {dot(way, camera.right()), dot(way, camera.down()), dot(way, camera.axis())};
}

/// The rectangle about places, as it grows.
class Bounds {
 public:
  explicit Bounds(const Pinhole& camera) : camera_(camera) {}
  void add(const Seen& at) noexcept {
    const double u = camera_.focal_u() * at.x / at.z, v = camera_.focal_v() * at.y / at.z;
    low_u_ = std::min(low_u_, u);
    high_u_ = std::max(high_u_, u);
    low_v_ = std::min(low_v_, v);
    high_v_ = std::max(high_v_, v);
  }
  /// The pixels whose middles lie within, or so near.
  [[nodiscard]] PixelBox pixels(double margin) const noexcept {
    PixelBox box;
    span(low_u_, high_u_, margin, camera_.wide(), box.first_u, box.last_u);
    span(low_v_, high_v_, margin, camera_.high(), box.first_v, box.last_v);
    return box;
  }

 private:
  static void span(double low, double high, double margin, int pixels, std::uint16_t& first,
                   std::uint16_t& last) noexcept {
    const double middle = 0.5 * pixels - 0.5;
    const double from = std::ceil(low - margin + middle), to = std::floor(high + margin + middle);
    if (!(from <= to && from <= pixels - 1 && to >= 0)) return;
    first = static_cast<std::uint16_t>(std::max(from, 0.0));
    last = static_cast<std::uint16_t>(std::min(to, pixels - 1.0));
  }
  const Pinhole& camera_;
  double low_u_ = endless, high_u_ = -endless, low_v_ = endless, high_v_ = -endless;
};

PixelBox whole(const Pinhole& camera) noexcept {
  return {0, static_cast<std::uint16_t>(camera.wide() - 1), 0,
          static_cast<std::uint16_t>(camera.high() - 1)};
}

double farthest_m(const Triple<double>& p) noexcept {
  return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

/// How far the box about a triangle is from the eye, along the axis in which it is farthest.
double off_box_m(const TriangleFromStart& t) noexcept {
  const auto off = [](double p, double q, double r) {
    return std::max({0.0, std::min({p, q, r}), -std::max({p, q, r})});
  };
  return std::max({off(t.a().x, t.b().x, t.c().x), off(t.a().y, t.b().y, t.c().y),
                   off(t.a().z, t.b().z, t.c().z)});
}

/// The pixels that could meet the box about a triangle that is seen edge-on.
PixelBox pixels_of_box(const Pinhole& camera, const TriangleFromStart& t, double reach_m) {
  const std::array corners{t.a(), t.b(), t.c()};
  Triple<double> low = t.a(), high = t.a();
  for (const Triple<double>& p : corners) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const double off_m = 1e-9 * reach_m;
  Bounds bounds(camera);
  double nearest_m = endless, last_m = -endless;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Triple<double> at{(corner & 1U) != 0 ? high.x + off_m : low.x - off_m,
                            (corner & 2U) != 0 ? high.y + off_m : low.y - off_m,
                            (corner & 4U) != 0 ? high.z + off_m : low.z - off_m};
    const Seen seen = seen_by(camera, at);
    nearest_m = std::min(nearest_m, seen.z);
    last_m = std::max(last_m, seen.z);
    if (seen.z > 0) bounds.add(seen);
  }
  if (last_m < 0) return {};
  return nearest_m > near_m ? bounds.pixels(spare_pixels) : whole(camera);
}

/// Whether the box about a triangle lies wholly beside the picture or behind it: told by one corner
/// and the box's size, so that most of a scene costs little.
class Beside {
 public:
  explicit Beside(const Pinhole& camera) noexcept
      : camera_(camera),
        wide_(0.5 * camera.wide() / camera.focal_u()),
        high_(0.5 * camera.high() / camera.focal_v()) {}
  [[nodiscard]] bool holds(const TriangleCorners& corners,
                           const Triple<double>& from_m) const noexcept {
    double size_m = 0, reach_m = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      const double low = std::min({corners[0][i], corners[1][i], corners[2][i]});
      const double high = std::max({corners[0][i], corners[1][i], corners[2][i]});
      size_m += high - low;
      reach_m += std::max(std::abs(low), std::abs(high));
    }
    const Seen a = seen_by(
        camera_, {corners[0][0] - from_m.x, corners[0][1] - from_m.y, corners[0][2] - from_m.z});
    // No place of the box is farther from the corner than its sides together.
    const double off_m =
        size_m + 1e-9 * (reach_m + std::abs(from_m.x) + std::abs(from_m.y) + std::abs(from_m.z));
    return a.z < -off_m || std::abs(a.x) - wide_ * a.z > (1 + wide_) * off_m ||
           std::abs(a.y) - high_ * a.z > (1 + high_) * off_m;
  }

 private:
  const Pinhole& camera_;
  double wide_, high_;
};

/// The pixels that could meet a triangle.
PixelBox pixels_of(const Pinhole& camera, const TriangleCorners& corners,
                   const Triple<double>& from_m) {
  TriangleFromStart t(corners, from_m);
  const std::array seen{seen_by(camera, t.a()), seen_by(camera, t.b()), seen_by(camera, t.c())};
  const double reach_m = 2 * std::max({farthest_m(t.a()), farthest_m(t.b()), farthest_m(t.c())});
  const double first_m = std::min({seen[0].z, seen[1].z, seen[2].z});
  const double last_m = std::max({seen[0].z, seen[1].z, seen[2].z});
  if (last_m < -1e-6 * reach_m) return {};
  t.lay_plane(corners);
  if (t.normal() == Triple<double>{}) return {};  // shrunk to a line: nothing meets it
  const double slack = 0x1p-46 * reach_m * reach_m * reach_m / std::abs(t.ahead());
  if (!(slack <= most_slack)) return pixels_of_box(camera, t, reach_m);
  // Beyond the corners by 2 e of the triangle's size, and by what the box of `range_along` allows.
  const double over_m = 4 * slack * 2 * reach_m + 1e-10 * reach_m;
  // A place in the picture that moves by s moves on it by no more than f s (1 + |x/z|) / z.
  const double aside = 2 + camera.wide() / camera.focal_u() + camera.high() / camera.focal_v();
  const double moved = std::max(camera.focal_u(), camera.focal_v()) * over_m * aside;
  Bounds bounds(camera);
  if (first_m > near_m + over_m) {
    for (const Seen& at : seen) bounds.add(at);
    return bounds.pixels(spare_pixels + moved / (first_m - over_m));
  }
  // What is in the picture and less than twice as far as the cut is so near to the eye.
  if (!(off_box_m(t) > aside * near_m + over_m)) return whole(camera);
  for (std::size_t i = 0; i < 3; ++i) {
    const Seen &p = seen[i], &q = seen[(i + 1) % 3];
    if (p.z >= near_m) bounds.add(p);
    if ((p.z >= near_m) == (q.z >= near_m)) continue;
    const double share = (near_m - p.z) / (q.z - p.z);
    bounds.add({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y), near_m});
  }
  return bounds.pixels(spare_pixels + moved / near_m);
}

/// Some of a mesh' triangles.
struct Chunk {
  std::uint32_t mesh = 0;
  std::size_t first = 0, last = 0;  ///< its triangles; `last` is not one of them
};

std::vector<Chunk> chunks_of(std::span<const TriangleMesh* const> meshes) {
  constexpr std::size_t most = 8192;
  std::vector<Chunk> chunks;
  for (std::uint32_t m = 0; m < meshes.size(); ++m)
    for (std::size_t first = 0; first < meshes[m]->triangles.size(); first += most) {
      const std::size_t last = std::min(first + most, meshes[m]->triangles.size());
      chunks.push_back({m, first, last});
    }
  return chunks;
}

TriangleCorners corners_of(const TriangleMesh& mesh, std::size_t triangle) noexcept {
  const auto& [a, b, c] = mesh.triangles[triangle];
  return {mesh.corners[a], mesh.corners[b], mesh.corners[c]};
}

/// A triangle that could be met, and where.
struct Found {
  PixelBox box;
  std::uint32_t triangle = 0;
};

/// Whether a place is on the triangle's outer side.
bool faces(const TriangleCorners& corners, const Triple<double>& from_m) noexcept {
  TriangleFromStart t(corners, from_m);
  t.lay_plane(corners);
  return t.ahead() < 0;
}

/// The columns of a row that could lie within the edges: what the signs of the volumes leave, which
/// are straight lines over the picture.
class RowSpans {
 public:
  RowSpans(const Pinhole& camera, const TriangleFromStart& t) noexcept : camera_(camera) {
    const double sign = t.ahead() < 0 ? -1 : 1;
    const double reach_m = 2 * std::max({farthest_m(t.a()), farthest_m(t.b()), farthest_m(t.c())});
    const double wide = camera.wide() / camera.focal_u() + camera.high() / camera.focal_v() + 1;
    slack_ = 0x1p-44 * reach_m * reach_m * wide;
    const std::array across{t.across_ab(), t.across_bc(), t.across_ca()};
    for (std::size_t i = 0; i < 3; ++i) {
      along_axis_[i] = sign * dot(across[i], camera.axis());
      along_right_[i] = sign * dot(across[i], camera.right()) / camera.focal_u();
      along_down_[i] = sign * dot(across[i], camera.down()) / camera.focal_v();
      per_slope_[i] = 1 / along_right_[i];
    }
    is_sound_ = 0x1p-46 * reach_m * reach_m * reach_m <= most_slack * std::abs(t.ahead());
  }
  /// Narrows [first, last] of row j.
  void narrow(int j, int& first, int& last) const noexcept {
    if (!is_sound_) return;
    const double down = j + 0.5 - 0.5 * camera_.high();
    const double middle = 0.5 * camera_.wide() - 0.5;
    for (std::size_t i = 0; i < 3; ++i) {
      const double at_middle = along_axis_[i] + down * along_down_[i] + slack_;
      const double slope = along_right_[i];
      if (std::abs(slope) * camera_.wide() <= slack_) {
        if (at_middle + slack_ < 0) last = first - 1;
        continue;
      }
      const double edge = middle - at_middle * per_slope_[i];
      if (slope > 0) {
        const double from = std::ceil(edge - spare_pixels);
        if (from > first) first = from > last ? last + 1 : static_cast<int>(from);
      } else {
        const double to = std::floor(edge + spare_pixels);
        if (to < last) last = to < first ? first - 1 : static_cast<int>(to);
      }
    }
  }

 private:
  const Pinhole& camera_;
  std::array<double, 3> along_axis_{}, along_right_{}, along_down_{}, per_slope_{};
  double slack_ = 0;
  bool is_sound_ = false;
};

/// Some rows of a picture, while the triangles come by.
class Band {
 public:
  Band(const Pinhole& camera, int first_row, int last_row, double most_range_m, FrameHits& hits)
      : camera_(camera),
        first_row_(first_row),
        last_row_(last_row),
        most_range_m_(most_range_m),
        hits_(hits) {
    const auto wide = static_cast<std::size_t>(camera.wide());
    directions_.reserve(wide * static_cast<std::size_t>(last_row - first_row));
    for (int j = first_row; j < last_row; ++j)
      for (int i = 0; i < camera.wide(); ++i) directions_.push_back(camera.ray(i, j).direction);
  }
  void meet(const PixelBox& box, std::uint32_t m, std::uint32_t triangle,
            const TriangleCorners& corners, const Triple<double>& from_m) {
    TriangleFromStart t(corners, from_m);
    t.lay_plane(corners);
    // No range in it is less, but for rounding and what the box of `range_along` allows.
    const double nearest_m =
        off_box_m(t) - 1e-9 * (farthest_m(t.a()) + farthest_m(t.b()) + farthest_m(t.c()));
    const int from_v = std::max<int>(box.first_v, first_row_);
    const int to_v = std::min<int>(box.last_v, last_row_ - 1);
    constexpr int large = 64;
    const int area = (box.last_u - box.first_u + 1) * (to_v - from_v + 1);
    if (area < large) {
      for (int j = from_v; j <= to_v; ++j)
        meet_row(j, box.first_u, box.last_u, m, triangle, t, nearest_m);
      return;
    }
    const RowSpans spans(camera_, t);
    for (int j = from_v; j <= to_v; ++j) {
      int first = box.first_u, last = box.last_u;
      spans.narrow(j, first, last);
      meet_row(j, first, last, m, triangle, t, nearest_m);
    }
  }

 private:
  void meet_row(int j, int first, int last, std::uint32_t m, std::uint32_t triangle,
                const TriangleFromStart& t, double nearest_m) {
    const auto wide = static_cast<std::size_t>(camera_.wide());
    const std::size_t in_band = static_cast<std::size_t>(j - first_row_) * wide;
    const std::size_t in_frame = static_cast<std::size_t>(j) * wide;
    for (int i = first; i <= last; ++i) {
      const std::size_t at = in_frame + static_cast<std::size_t>(i);
      double& best_m = hits_.range_m[at];
      if (nearest_m > best_m) continue;
      const Triple<double>& direction = directions_[in_band + static_cast<std::size_t>(i)];
      if (!t.is_within_edges(direction)) continue;
      const auto range_m = t.range_along(direction, std::min(most_range_m_, best_m));
      if (!range_m) continue;
      // Of two at one range the lesser (mesh, triangle) stays.
      if (*range_m == best_m &&
          std::tie(hits_.mesh[at], hits_.triangle[at]) < std::tie(m, triangle))
        continue;
      hits_.range_m[at] = *range_m;
      hits_.mesh[at] = m;
      hits_.triangle[at] = triangle;
    }
  }
  const Pinhole& camera_;
  int first_row_, last_row_;
  double most_range_m_;
  FrameHits& hits_;
  std::vector<Triple<double>> directions_;
};

}  // namespace

void find_first_hits(const Pinhole& camera, std::span<const TriangleMesh* const> meshes,
                     double most_range_m, int threads, FrameHits& hits) {
  const auto pixels =
      static_cast<std::size_t>(camera.wide()) * static_cast<std::size_t>(camera.high());
  hits.wide = camera.wide();
  hits.high = camera.high();
  hits.range_m.assign(pixels, endless);
  hits.mesh.assign(pixels, FrameHits::nothing);
  hits.triangle.assign(pixels, FrameHits::nothing);
  const std::vector<Chunk> chunks = chunks_of(meshes);
  if (chunks.empty() || pixels == 0) return;
  constexpr int rows_of_band = 48;
  const int bands = (camera.high() + rows_of_band - 1) / rows_of_band;
  // What a chunk has for each band: those that face the camera, and then the others, which are
  // mostly hidden by them.
  std::vector<std::vector<std::vector<Found>>> found(chunks.size());
  const Beside beside(camera);
  for_all(chunks.size(), threads, [&](std::size_t c) {
    const Chunk& chunk = chunks[c];
    const TriangleMesh& mesh = *meshes[chunk.mesh];
    const Triple<double> from_m = camera.position_m() - mesh.origin_m;
    for (std::size_t t = chunk.first; t < chunk.last; ++t) {
      const TriangleCorners corners = corners_of(mesh, t);
      if (beside.holds(corners, from_m)) continue;
      const PixelBox box = pixels_of(camera, corners, from_m);
      if (box.is_empty()) continue;
      if (found[c].empty()) found[c].resize(2 * static_cast<std::size_t>(bands));
      const auto side = static_cast<std::size_t>(faces(corners, from_m) ? 0 : bands);
      for (int b = box.first_v / rows_of_band; b <= box.last_v / rows_of_band; ++b)
        found[c][side + static_cast<std::size_t>(b)].push_back(
            {box, static_cast<std::uint32_t>(t)});
    }
  });
  for_all(static_cast<std::size_t>(bands), threads, [&](std::size_t b) {
    const int first = static_cast<int>(b) * rows_of_band;
    Band band(camera, first, std::min(first + rows_of_band, camera.high()), most_range_m, hits);
    for (const std::size_t side : {std::size_t{0}, static_cast<std::size_t>(bands)})
      for (std::size_t c = 0; c < chunks.size(); ++c) {
        if (found[c].empty()) continue;
        const std::uint32_t m = chunks[c].mesh;
        const TriangleMesh& mesh = *meshes[m];
        const Triple<double> from_m = camera.position_m() - mesh.origin_m;
        for (const Found& one : found[c][side + b])
          band.meet(one.box, m, one.triangle, corners_of(mesh, one.triangle), from_m);
      }
  });
}

}  // namespace slackwater::twin
