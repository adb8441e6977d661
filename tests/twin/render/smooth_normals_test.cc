#include "twin/render/light/smooth_normals.h"

#include <gtest/gtest.h>

#include "tests/twin/inspection/meshes_for_tests.h"

namespace slackwater::twin::smooth_normals_test {
namespace {

Triple<double> unit_face(const TriangleMesh& mesh, std::size_t t) {
  const Triple<double> area = mesh.area_vector_m2(t);
  return (1 / length_of(area)) * area;
}
/// Of a triangle, by the weights of its corners.
Triple<double> place(const TriangleMesh& mesh, std::size_t t, double a, double b) {
  const auto& [i, j, k] = mesh.triangles[t];
  return a * mesh.corner_m(i) + b * mesh.corner_m(j) + (1 - a - b) * mesh.corner_m(k);
}

/// At a corner where one face has two triangles and the others have one each, their mean stands
/// only 35 degrees off that face: less than what is rounded off. The edges stand at 90.
TEST(SmoothNormals, OfABoxAreThoseOfItsFaces) {
  TriangleMesh box;
  for (int i = 0; i < 8; ++i)
    box.corners.push_back({i & 1 ? 1.F : -1.F, i & 2 ? 1.F : -1.F, i & 4 ? 1.F : -1.F});
  box.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5}, {0, 5, 4},
                   {2, 6, 7}, {2, 7, 3}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
  const SmoothNormals normals(box);
  for (std::size_t t = 0; t < box.triangles.size(); ++t) {
    const Triple<double> face = unit_face(box, t);
    for (const double a : {0.02, 0.5, 0.96})
      EXPECT_LT(length_of(normals.at(t, place(box, t, a, 0.02), face) - face), 1e-12) << t;
  }
}

/// Faces of 15 degrees: at their corners the normal is the axis's own radius, to what two triangles
/// of one face and one of the next leave (a third of 15 degrees at most, a half with one of each).
TEST(SmoothNormals, OfACylinderTurnRoundWithIt) {
  const TriangleMesh pile = cylinder_mesh({0, 0, 0}, 3, 10, 24, 4);
  const SmoothNormals normals(pile);
  double last = 1;
  for (std::size_t t = 0; t < pile.triangles.size(); ++t) {
    const Triple<double> face = unit_face(pile, t);
    for (const auto& [a, b] : {std::pair{0.98, 0.01}, std::pair{0.01, 0.98}, std::pair{0.3, 0.3}}) {
      const Triple<double> at_m = place(pile, t, a, b);
      const Triple<double> normal = normals.at(t, at_m, face);
      const double length = std::hypot(at_m.x, at_m.y);
      const double along = (normal.x * at_m.x + normal.y * at_m.y) / length;
      EXPECT_GT(along, std::cos(4 * constants::degree)) << t;
      EXPECT_NEAR(length_of(normal), 1, 1e-12);
      last = std::min(last, along);
    }
  }
  EXPECT_LT(std::cos(7.5 * constants::degree), last) << "a face is up to 7.5 degrees off";
}

}  // namespace
}  // namespace slackwater::twin::smooth_normals_test
