#include <gtest/gtest.h>

#include <cmath>

#include "tests/twin/inspection/surface/surface_for_tests.h"

// What holds of every surface, whatever its shape.

namespace slackwater::tests::every_surface_test {
namespace {

using twin::Surface;
using twin::SurfaceKind;
using twin::Triple;

struct Each {
  const char* entry;
  bool is_solid;
};

class EachSurface : public testing::TestWithParam<Each> {};

bool is_round(SurfaceKind kind) {
  return kind == SurfaceKind::monopile || kind == SurfaceKind::tower;
}

TEST_P(EachSurface, PatchesAreTheMeshsTrianglesAndTheirAreasSumUp) {
  for (const double patch_m : {2.0, 0.5, 0.31}) {
    const Surface surface = surface_of(GetParam().entry, patch_m);
    ASSERT_EQ(surface.patch_of.size(), surface.mesh.triangles.size());
    ASSERT_FALSE(surface.patches.empty());
    std::vector<double> area_m2(surface.patches.size());
    std::vector<Triple<double>> facing(surface.patches.size());
    double seen_m2 = 0;
    for (std::size_t t = 0; t < surface.patch_of.size(); ++t) {
      const std::uint32_t patch = surface.patch_of[t];
      if (patch == twin::no_patch) continue;
      ASSERT_LT(patch, surface.patches.size());
      const double m2 = twin::length_of(surface.mesh.area_vector_m2(t));
      EXPECT_GT(m2, 0);
      area_m2[patch] += m2;
      seen_m2 += m2;
      facing[patch] = facing[patch] + surface.mesh.area_vector_m2(t);
    }
    EXPECT_NEAR(surface.area_m2(), seen_m2, 1e-9 * seen_m2);
    for (std::size_t p = 0; p < area_m2.size(); ++p) {
      const twin::Patch& patch = surface.patches[p];
      EXPECT_NEAR(patch.area_m2, area_m2[p], 1e-12 + 1e-9 * area_m2[p]);
      EXPECT_NEAR(twin::length_of(patch.normal), 1, 1e-12);
      EXPECT_GT(twin::dot(patch.normal, facing[p]), 0.5 * area_m2[p]);
    }
  }
}

TEST_P(EachSurface, NoPatchIsLongerThanAskedForAndTheyAreAsFewAsThat) {
  for (const double patch_m : {2.0, 0.5}) {
    const Surface surface = surface_of(GetParam().entry, patch_m);
    for (const twin::Patch& patch : surface.patches) {
      EXPECT_LE(patch.width_m, patch_m * (1 + 1e-6));
      EXPECT_LE(patch.height_m, patch_m * (1 + 1e-6));
      EXPECT_GT(patch.width_m, 0);
      EXPECT_GT(patch.height_m, 0);
      EXPECT_GE(patch.along_m, 0);
      EXPECT_LE(patch.along_m, surface.sheet.width_m);
      EXPECT_GE(patch.down_m, 0);
      EXPECT_LE(patch.down_m, surface.sheet.height_m);
    }
  }
}

/// The centre lies within a triangle of its own patch, off its edges: a ray that is cast at it
/// cannot slip between two.
TEST_P(EachSurface, TheCentreOfAPatchIsWithinOneOfItsTriangles) {
  for (const double patch_m : {2.0, 0.5}) {
    const Surface surface = surface_of(GetParam().entry, patch_m);
    std::vector<int> within(surface.patches.size());
    for (std::size_t t = 0; t < surface.patch_of.size(); ++t) {
      if (surface.patch_of[t] == twin::no_patch) continue;
      const twin::Patch& patch = surface.patches[surface.patch_of[t]];
      const auto& corners = surface.mesh.triangles[t];
      const Triple<double> whole = surface.mesh.area_vector_m2(t);
      const double twice_m2 = 2 * twin::dot(whole, whole);
      bool is_within = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const Triple<double> a = surface.mesh.corner_m(corners[i]) - patch.centre_m;
        const Triple<double> b = surface.mesh.corner_m(corners[(i + 1) % 3]) - patch.centre_m;
        // Its share of the triangle, by barycentric coordinates: the least is a tenth of a third.
        is_within &= twin::dot(twin::cross(a, b), whole) / twice_m2 > 0.033;
      }
      const double off_m = std::abs(twin::dot(patch.centre_m - surface.mesh.centroid_m(t), whole)) /
                           twin::length_of(whole);
      if (is_within && off_m < 1e-9) ++within[surface.patch_of[t]];
    }
    for (std::size_t p = 0; p < within.size(); ++p) EXPECT_EQ(within[p], 1) << p;
  }
}

TEST_P(EachSurface, SolidsAreClosedAndFaceOutward) {
  const Surface surface = surface_of(GetParam().entry, 0.5);
  EXPECT_EQ(twin::is_closed(surface.mesh), GetParam().is_solid);
  if (GetParam().is_solid) {
    EXPECT_GT(twin::volume_m3(surface.mesh), 0);
  }
  for (const twin::Patch& patch : surface.patches) {
    if (is_round(surface.kind)) {
      const Triple<double> off{patch.centre_m.x - 1200, patch.centre_m.y + 800, 0};
      EXPECT_GT(twin::dot(patch.normal, off), 0.9 * twin::length_of(off));
    }
    if (surface.kind == SurfaceKind::bed || surface.kind == SurfaceKind::water ||
        surface.kind == SurfaceKind::cable) {
      EXPECT_LT(patch.normal.z, -0.5);
    }
  }
}

TEST_P(EachSurface, IsTheSameEachTimeAndSaysWhatItsSheetShows) {
  const Surface a = surface_of(GetParam().entry, 0.7), b = surface_of(GetParam().entry, 0.7);
  EXPECT_EQ(a.mesh.corners, b.mesh.corners);
  EXPECT_EQ(a.mesh.triangles, b.mesh.triangles);
  EXPECT_EQ(a.patch_of, b.patch_of);
  EXPECT_STREQ(a.name.c_str(), twin::name_of(a.kind));
  EXPECT_FALSE(a.sheet.along.empty());
  EXPECT_FALSE(a.sheet.down.empty());
}

INSTANTIATE_TEST_SUITE_P(Kinds, EachSurface,
                         testing::Values(Each{monopile_entry, true}, Each{transition_entry, true},
                                         Each{tower_entry, true}, Each{nacelle_entry, true},
                                         Each{blade_entry, true}, Each{anodes_entry, true},
                                         Each{mooring_entry, true}, Each{cable_entry, false},
                                         Each{bed_entry, false}, Each{water_entry, false}),
                         [](const auto& tested) {
                           const std::string entry = tested.param.entry;
                           return entry.substr(6, entry.find(',') - 6);
                         });

}  // namespace
}  // namespace slackwater::tests::every_surface_test
