#pragma once
#include <utility>
#include <vector>

#include "tests/twin/inspection/meshes_for_tests.h"
#include "tests/twin/render/render_for_tests.h"
#include "twin/inspection/cast/ray_caster.h"
#include "twin/render/scene/render_scene.h"

namespace slackwater::twin {

/// A scene of things and what rays at it meet.
struct Cast {
  RenderScene scene;
  RayCaster caster;

  explicit Cast(std::vector<TriangleMesh> meshes, const char* isa = "")
      : scene(of(meshes)), caster(meshes, isa) {}
  explicit Cast(TriangleMesh mesh) : Cast(std::vector<TriangleMesh>{std::move(mesh)}) {}
  static RenderScene of(const std::vector<TriangleMesh>& meshes) {
    RenderScene scene;
    for (const TriangleMesh& mesh : meshes)
      scene.things.push_back({"thing", SeenClass::structure, Material::none, mesh});
    return scene;
  }
};

/// An upright wall, facing south, `ahead_m` north.
inline TriangleMesh wall_mesh(double ahead_m) {
  return {{ahead_m, 0, 0},
          {{0, -200, -200}, {0, 200, -200}, {0, 200, 200}, {0, -200, 200}},
          {{0, 2, 1}, {0, 3, 2}}};
}

/// A bed below the origin at a depth, which falls off by so much for each metre east.
inline TriangleMesh sloping_mesh(double depth_m, double fall) {
  const auto s = static_cast<float>(200 * fall);
  return {{0, 0, depth_m},
          {{-200, -200, -s}, {200, -200, -s}, {200, 200, s}, {-200, 200, s}},
          {{0, 1, 2}, {0, 2, 3}}};
}

/// A sphere north of the origin.
inline TriangleMesh sphere_mesh(double ahead_m, double radius_m, std::uint32_t rings) {
  TriangleMesh mesh;
  mesh.origin_m = {ahead_m, 0, 0};
  const std::uint32_t round = 2 * rings;
  for (std::uint32_t k = 0; k <= rings; ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const double up = constants::pi * k / rings, turn = 2 * constants::pi * i / round;
      mesh.corners.push_back({static_cast<float>(radius_m * std::sin(up) * std::cos(turn)),
                              static_cast<float>(radius_m * std::sin(up) * std::sin(turn)),
                              static_cast<float>(-radius_m * std::cos(up))});
    }
  for (std::uint32_t k = 0; k < rings; ++k)
    for (std::uint32_t i = 0; i < round; ++i) {
      const std::uint32_t a = k * round + i, b = k * round + (i + 1) % round;
      mesh.triangles.push_back({a, b, b + round});
      mesh.triangles.push_back({a, b + round, a + round});
    }
  return mesh;
}

/// At the origin, looking down, the bow to the north: east is to the right.
inline Pose looking_down() {
  Pose pose = looking({0, 0, 0}, {0, 0, 1});
  pose.right = {0, 1, 0};
  return pose;
}

}  // namespace slackwater::twin
