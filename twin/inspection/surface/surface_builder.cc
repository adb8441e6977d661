#include "twin/inspection/surface/surface_builder.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "fields/base/check.h"

namespace slackwater::twin {

SurfaceBuilder::SurfaceBuilder(const Triple<double>& origin_m) {
  surface_.mesh.origin_m = origin_m;
}

void SurfaceBuilder::expect_room(std::size_t patches, std::size_t triangles) const {
  if (surface_.patches.size() + patches > TooManyPatches::most_patches ||
      surface_.mesh.triangles.size() + triangles > TooManyPatches::most_triangles)
    throw TooManyPatches();
}

std::uint32_t SurfaceBuilder::add_corner(const Triple<double>& at_m) {
  const Triple<double> own = at_m - surface_.mesh.origin_m;
  surface_.mesh.corners.push_back(
      {static_cast<float>(own.x), static_cast<float>(own.y), static_cast<float>(own.z)});
  return static_cast<std::uint32_t>(surface_.mesh.corners.size() - 1);
}

std::uint32_t SurfaceBuilder::add_patch(double along_m, double down_m, double width_m,
                                        double height_m) {
  Patch& patch = surface_.patches.emplace_back();
  patch.along_m = along_m;
  patch.down_m = down_m;
  patch.width_m = static_cast<float>(width_m);
  patch.height_m = static_cast<float>(height_m);
  return static_cast<std::uint32_t>(surface_.patches.size() - 1);
}

void SurfaceBuilder::add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                  std::uint32_t patch) {
  surface_.mesh.triangles.push_back({a, b, c});
  surface_.patch_of.push_back(patch);
}

void SurfaceBuilder::put_centre(std::uint32_t patch, const std::array<std::uint32_t, 3>& corners,
                                const std::array<double, 3>& weights) {
  Triple<double> centre_m;
  for (std::size_t i = 0; i < 3; ++i)
    centre_m = centre_m + weights[i] * surface_.mesh.corner_m(corners[i]);
  surface_.patches[patch].centre_m = centre_m;
}

void SurfaceBuilder::add_cap(const std::vector<std::uint32_t>& ring) {
  Triple<double> middle_m;
  for (const std::uint32_t corner : ring) middle_m = middle_m + surface_.mesh.corner_m(corner);
  const std::uint32_t middle = add_corner((1.0 / static_cast<double>(ring.size())) * middle_m);
  for (std::size_t i = 0; i < ring.size(); ++i)
    add_triangle(middle, ring[i], ring[(i + 1) % ring.size()]);
}

Surface SurfaceBuilder::finish(SurfaceKind kind, Sheet sheet) {
  surface_.kind = kind;
  surface_.sheet = std::move(sheet);
  for (std::size_t t = 0; t < surface_.patch_of.size(); ++t) {
    if (surface_.patch_of[t] == no_patch) continue;
    Patch& patch = surface_.patches[surface_.patch_of[t]];
    const Triple<double> area_m2 = surface_.mesh.area_vector_m2(t);
    patch.area_m2 += length_of(area_m2);
    patch.normal = patch.normal + area_m2;
  }
  for (Patch& patch : surface_.patches) {
    const double length_m2 = length_of(patch.normal);
    expects(length_m2 > 0, "a patch faces somewhere");
    patch.normal = (1 / length_m2) * patch.normal;
  }
  return std::move(surface_);
}

std::size_t pieces_in(double length_m, double piece_m) {
  return static_cast<std::size_t>(std::max(1.0, std::ceil(length_m / piece_m - 1e-6)));
}

std::size_t odd_from(double least) {
  const auto whole = static_cast<std::size_t>(std::max(1.0, std::ceil(least - 1e-6)));
  return whole + (whole % 2 == 0 ? 1 : 0);
}

}  // namespace slackwater::twin
