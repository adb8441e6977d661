#include "twin/inspection/surface/triangle_mesh.h"

#include <gtest/gtest.h>

#include "tests/support/error_of.h"
#include "tests/twin/inspection/surface/surface_for_tests.h"

namespace slackwater::tests::triangle_mesh_test {
namespace {

/// Corner at the origin, edges along the axes, far away.
twin::TriangleMesh tetrahedron() {
  twin::TriangleMesh mesh;
  mesh.origin_m = {1e6, -2e6, 3};
  mesh.corners = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  mesh.triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
  return mesh;
}

TEST(TriangleMesh, ATetrahedronHasItsVolumeAndArea) {
  const twin::TriangleMesh mesh = tetrahedron();
  EXPECT_TRUE(twin::is_closed(mesh));
  EXPECT_DOUBLE_EQ(twin::volume_m3(mesh), 1);
  // Three right angles, and the face across them: half of |(-1, 2, 0) x (-1, 0, 3)| = 3.5.
  EXPECT_DOUBLE_EQ(twin::area_m2(mesh), 1 + 1.5 + 3 + 3.5);
  twin::Triple<double> sum;
  for (std::size_t t = 0; t < 4; ++t) sum = sum + mesh.area_vector_m2(t);
  EXPECT_EQ(twin::length_of(sum), 0);
  EXPECT_EQ(mesh.corner_m(3).z, 6);
  EXPECT_DOUBLE_EQ(mesh.centroid_m(3).z, 4);
}

TEST(TriangleMesh, AHoleATurnedTriangleAndADoubleOneAreNotClosed) {
  for (std::size_t t = 0; t < 4; ++t) {
    twin::TriangleMesh mesh = tetrahedron();
    mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
    EXPECT_FALSE(twin::is_closed(mesh));
    mesh = tetrahedron();
    std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
    EXPECT_FALSE(twin::is_closed(mesh));
    mesh = tetrahedron();
    mesh.triangles.push_back(mesh.triangles[t]);
    EXPECT_FALSE(twin::is_closed(mesh));
    // Two skins, one in the other: each edge four times.
    mesh = tetrahedron();
    mesh.triangles.insert(mesh.triangles.end(), mesh.triangles.begin(), mesh.triangles.end());
    EXPECT_FALSE(twin::is_closed(mesh));
  }
  EXPECT_FALSE(twin::is_closed({}));
}

TEST(Surface, OneWithAHoleOrInsideOutIsRefused) {
  twin::Surface pile = surface_of(monopile_entry, 1);
  EXPECT_NO_THROW(twin::expect_closed(pile));
  const auto message = [&] {
    return error_of([&] {
      twin::expect_closed(pile);
      return 0;
    });
  };
  const auto whole = pile.mesh.triangles;
  pile.mesh.triangles.pop_back();
  EXPECT_NE(message().find("does not close"), std::string::npos) << message();
  pile.mesh.triangles = whole;
  for (auto& t : pile.mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_NE(message().find("face inward"), std::string::npos) << message();
}

}  // namespace
}  // namespace slackwater::tests::triangle_mesh_test
