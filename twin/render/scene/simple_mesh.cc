#include "twin/render/scene/simple_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fields/base/check.h"
#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

std::uint32_t add(TriangleMesh& mesh, const Triple<double>& from_origin_m) {
  mesh.corners.push_back({static_cast<float>(from_origin_m.x), static_cast<float>(from_origin_m.y),
                          static_cast<float>(from_origin_m.z)});
  return static_cast<std::uint32_t>(mesh.corners.size() - 1);
}

/// Rings of as many corners each, clockwise as seen along the way from the first to the last, and
/// closed at both ends: outward.
void add_rings(TriangleMesh& mesh, const std::vector<std::vector<Triple<double>>>& rings) {
  const auto round = static_cast<std::uint32_t>(rings.front().size());
  const auto first = static_cast<std::uint32_t>(mesh.corners.size());
  for (const auto& ring : rings)
    for (const Triple<double>& at : ring) add(mesh, at);
  for (std::uint32_t k = 0; k + 1 < rings.size(); ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = first + k * round + i, b = first + k * round + (i + 1) % round;
      mesh.triangles.push_back({a, b, b + round});
      mesh.triangles.push_back({a, b + round, a + round});
    }
  const std::uint32_t last = first + (static_cast<std::uint32_t>(rings.size()) - 1) * round;
  for (std::uint32_t i = 1; i + 1 < round; ++i) {
    mesh.triangles.push_back({first, first + i + 1, first + i});
    mesh.triangles.push_back({last, last + i, last + i + 1});
  }
}

TriangleMesh made(const Cylinder& c) {
  constexpr int round = 96;
  TriangleMesh mesh;
  mesh.origin_m = {c.north_m, c.east_m, c.top_m};
  std::vector<std::vector<Triple<double>>> rings(2);
  for (int i = 0; i < round; ++i) {
    const double bearing = 2 * constants::pi * i / round;
    const double north = c.radius_m * std::cos(bearing), east = c.radius_m * std::sin(bearing);
    rings[0].push_back({north, east, 0});
    rings[1].push_back({north, east, c.bottom_m - c.top_m});
  }
  add_rings(mesh, rings);
  return mesh;
}

TriangleMesh made(const Box& b) {
  TriangleMesh mesh;
  mesh.origin_m = b.centre_m;
  const Triple<double>& h = b.half_size_m;
  const auto at = [&](double x, double y, double z) -> Triple<double> {
    return {b.heading_cosine * x - b.heading_sine * y, b.heading_sine * x + b.heading_cosine * y,
            z};
  };
  std::vector<std::vector<Triple<double>>> rings;
  for (const double z : {-h.z, h.z})
    rings.push_back({at(h.x, h.y, z), at(-h.x, h.y, z), at(-h.x, -h.y, z), at(h.x, -h.y, z)});
  add_rings(mesh, rings);
  return mesh;
}

using Ring = std::vector<Triple<double>>;

/// A rectangle with its corners cut, across the vehicle, clockwise as seen from behind.
Ring cut_rectangle(double x, double half_y, double half_z, double middle_z) {
  const double y = half_y, z = half_z, cy = 0.8 * half_y, cz = 0.8 * half_z;
  Ring ring{{x, cy, -z}, {x, y, -cz}, {x, y, cz},   {x, cy, z},
            {x, -cy, z}, {x, -y, cz}, {x, -y, -cz}, {x, -cy, -z}};
  for (Triple<double>& at : ring) at.z += middle_z;
  return ring;
}

std::vector<Ring> box_rings(const Triple<double>& half) {
  return {cut_rectangle(-half.x, 0.8 * half.y, 0.8 * half.z, 0),
          cut_rectangle(-0.8 * half.x, half.y, half.z, 0),
          cut_rectangle(0.8 * half.x, half.y, half.z, 0),
          cut_rectangle(half.x, 0.8 * half.y, 0.8 * half.z, 0)};
}

std::vector<Ring> boat_rings(const Triple<double>& half) {
  return {cut_rectangle(-half.x, half.y, half.z, 0), cut_rectangle(0.4 * half.x, half.y, half.z, 0),
          cut_rectangle(0.8 * half.x, 0.6 * half.y, 0.8 * half.z, -0.2 * half.z),
          cut_rectangle(half.x, 0.05 * half.y, 0.4 * half.z, -0.6 * half.z)};
}

std::vector<Ring> spindle_rings(const Triple<double>& half) {
  constexpr int round = 24;
  std::vector<Ring> rings;
  // Half ellipses over a sixth of the length at either end.
  for (const double share : {-1.0, -0.98, -0.93, -0.83, -0.67, 0.67, 0.83, 0.93, 0.98, 1.0}) {
    const double out = std::max(0.0, (std::abs(share) - 0.67) / 0.33);
    const double wide = std::max(0.05, std::sqrt(std::max(0.0, 1 - out * out)));
    Ring ring;
    for (int i = 0; i < round; ++i) {
      const double turn = 2 * constants::pi * i / round;
      ring.push_back(
          {share * half.x, wide * half.y * std::cos(turn), wide * half.z * std::sin(turn)});
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

}  // namespace

TriangleMesh mesh_of(const Structure& structure) {
  return std::visit([](const auto& shape) { return made(shape); }, structure);
}

TriangleMesh hull_mesh(VehicleKind kind, const Triple<double>& size_m,
                       const Triple<double>& position_m, const Rotation<double>& body) {
  const Triple<double> half = 0.5 * size_m;
  std::vector<Ring> rings;
  if (kind == VehicleKind::auv)
    rings = spindle_rings(half);
  else if (kind == VehicleKind::usv || kind == VehicleKind::vessel)
    rings = boat_rings(half);
  else
    rings = box_rings(half);
  for (Ring& ring : rings)
    for (Triple<double>& at : ring) at = body.to_ned(at);
  TriangleMesh mesh;
  mesh.origin_m = position_m;
  add_rings(mesh, rings);
  return mesh;
}

TriangleMesh line_mesh(const std::vector<Triple<double>>& at_m, double diameter_m) {
  constexpr int faces = 6;
  expects(at_m.size() >= 2, "a line has two ends");
  TriangleMesh mesh;
  mesh.origin_m = at_m.front();
  std::vector<std::vector<Triple<double>>> rings;
  Triple<double> aside{};
  for (std::size_t k = 0; k < at_m.size(); ++k) {
    const Triple<double> way = at_m[std::min(k + 1, at_m.size() - 1)] - at_m[k == 0 ? 0 : k - 1];
    const Triple<double> along = (1 / length_of(way)) * way;
    // Carried on from the ring before, so that the faces do not wind about the line.
    if (k == 0) aside = std::abs(along.z) < 0.7 ? Triple<double>{0, 0, 1} : Triple<double>{1, 0, 0};
    aside = aside - dot(aside, along) * along;
    aside = (1 / length_of(aside)) * aside;
    const Triple<double> other = cross(along, aside);
    rings.emplace_back();
    for (int i = 0; i < faces; ++i) {
      const double turn = 2 * constants::pi * i / faces;
      rings.back().push_back(at_m[k] - mesh.origin_m +
                             (0.5 * diameter_m) *
                                 (std::cos(turn) * aside + std::sin(turn) * other));
    }
  }
  add_rings(mesh, rings);
  return mesh;
}

TriangleMesh bed_mesh(const Triple<double>& middle_m, double reach_m, double square_m,
                      const std::vector<LevelDisc>& left_out) {
  TriangleMesh mesh;
  mesh.origin_m = middle_m;
  const auto squares = static_cast<std::uint32_t>(2 * std::ceil(reach_m / square_m));
  const double first = -0.5 * squares * square_m;
  const auto is_out = [&](std::uint32_t i, std::uint32_t j) {
    const double north = middle_m.x + first + square_m * i;
    const double east = middle_m.y + first + square_m * j;
    return std::any_of(left_out.begin(), left_out.end(), [&](const LevelDisc& disc) {
      return std::hypot(north - disc.north_m, east - disc.east_m) < disc.radius_m;
    });
  };
  for (std::uint32_t i = 0; i <= squares; ++i)
    for (std::uint32_t j = 0; j <= squares; ++j)
      add(mesh, {first + square_m * i, first + square_m * j, 0});
  for (std::uint32_t i = 0; i < squares; ++i)
    for (std::uint32_t j = 0; j < squares; ++j) {
      if (is_out(i, j) && is_out(i + 1, j) && is_out(i, j + 1) && is_out(i + 1, j + 1)) continue;
      const std::uint32_t a = i * (squares + 1) + j, b = a + 1, c = a + squares + 1, d = c + 1;
      mesh.triangles.push_back({a, d, c});
      mesh.triangles.push_back({a, b, d});
    }
  return mesh;
}

}  // namespace slackwater::twin
