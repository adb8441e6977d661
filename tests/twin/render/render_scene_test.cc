#include "twin/render/scene/render_scene.h"

#include <gtest/gtest.h>

#include <cmath>

#include "fields/base/constants.h"
#include "fields/wave/wave_component.h"
#include "twin/body/attitude.h"
#include "twin/inspection/surface/make_surface.h"
#include "twin/render/scene/sea_mesh.h"
#include "twin/render/scene/simple_mesh.h"

namespace slackwater::twin::render_scene_test {
namespace {

TEST(SimpleMesh, HullsAreClosedOutwardAndAsLargeAsTheirSheet) {
  const Triple<double> size_m{4, 2, 1};
  EulerAngles angles;
  angles.yaw_rad = 0.5 * constants::pi;  // the bow to the east
  for (const VehicleKind kind : {VehicleKind::rov, VehicleKind::auv, VehicleKind::uav,
                                 VehicleKind::usv, VehicleKind::vessel}) {
    const TriangleMesh mesh =
        hull_mesh(kind, size_m, {100, 50, 20}, rotation_of(attitude_of(angles)));
    EXPECT_TRUE(is_closed(mesh)) << name_of(kind);
    EXPECT_GT(volume_m3(mesh), 0.4 * 4 * 2 * 1) << name_of(kind);
    EXPECT_LE(volume_m3(mesh), 4 * 2 * 1) << name_of(kind);
    Triple<double> low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
      const Triple<double> at = mesh.corner_m(i);
      low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
      high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
    }
    EXPECT_NEAR(high.x - low.x, 2, 1e-5) << name_of(kind);
    EXPECT_NEAR(high.y - low.y, 4, 1e-5) << name_of(kind);
    EXPECT_NEAR(high.z - low.z, 1, 1e-5) << name_of(kind);
  }
}

TEST(SimpleMesh, StructuresAreClosedOutward) {
  const TriangleMesh pile = mesh_of(Cylinder{3, -2, 4, -10, 30});
  EXPECT_TRUE(is_closed(pile));
  const double of_prism = 96 / (2 * constants::pi) * std::sin(2 * constants::pi / 96);
  EXPECT_NEAR(volume_m3(pile), of_prism * constants::pi * 16 * 40, 1e-2);
  const TriangleMesh box = mesh_of(box_of({1, 2, 3}, {2, 1, 0.5}, 0.4));
  EXPECT_TRUE(is_closed(box));
  EXPECT_NEAR(volume_m3(box), 8, 1e-5);
}

TEST(SimpleMesh, ALineIsClosedOutwardAndAsThickAsItSays) {
  const std::vector<Triple<double>> straight{{1, 2, 3}, {1, 2, 7}, {1, 2, 13}};
  const TriangleMesh line = line_mesh(straight, 0.2);
  EXPECT_TRUE(is_closed(line));
  const double of_hexagon = 1.5 * std::sqrt(3.0) * 0.1 * 0.1;
  EXPECT_NEAR(volume_m3(line), of_hexagon * 10, 1e-5);
  const TriangleMesh bent = line_mesh({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, -1}}, 0.02);
  EXPECT_TRUE(is_closed(bent));
  EXPECT_GT(volume_m3(bent), 0);
}

TEST(SimpleMesh, ABedFacesUpAndLeavesOutWhatElseShowsIt) {
  const TriangleMesh bed = bed_mesh({10, 20, 30}, 40, 2, {{10, 20, 12}});
  for (std::size_t t = 0; t < bed.triangles.size(); ++t) EXPECT_LT(bed.area_vector_m2(t).z, 0);
  const double whole = 80.0 * 80, hole = constants::pi * 144;
  EXPECT_NEAR(area_m2(bed), whole - hole, 0.35 * hole) << "no more than whole squares stay out";
  EXPECT_GT(area_m2(bed), whole - hole) << "no gap about what else shows it";
}

// One wave of the run: the surface is where its cosine is.
TEST(SeaMesh, IsTheSurfaceOfTheRunsWaves) {
  const WaveWater water{30, {}};
  const auto wave =
      wave_component(0.7, 2 * constants::pi / 6, FrequencyFrame::intrinsic, 200, 0.4, water);
  ASSERT_TRUE(wave);
  const SeaRealisation sea({*wave}, water, {});
  const TriangleMesh mesh = sea_mesh(&sea, {100, -50, 7}, 60, 12.5);
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Triple<double> at = mesh.corner_m(i);
    const double phase = wave->wavenumber_rad_m.real() * at.y +
                         wave->wavenumber_rad_m.imag() * at.x - wave->absolute_rad_s * 12.5 + 0.4;
    EXPECT_NEAR(-at.z, 0.7 * std::cos(phase), 1e-5);
  }
}

TEST(SeaMesh, FacesUpAndReachesAsFarAsItIsAsked) {
  const TriangleMesh sea = sea_mesh(nullptr, {100, -50, 7}, 200, 0);
  double far_m = 0;
  for (std::size_t t = 0; t < sea.triangles.size(); ++t) ASSERT_LE(sea.area_vector_m2(t).z, 0) << t;
  for (std::size_t i = 0; i < sea.corners.size(); ++i) {
    const Triple<double> at = sea.corner_m(i);
    EXPECT_EQ(at.z, 0);
    far_m = std::max(far_m, std::hypot(at.x - 100, at.y + 50));
  }
  EXPECT_NEAR(far_m, 200, 1e-4);
  // All of a polygon of 160 corners.
  EXPECT_NEAR(area_m2(sea), 80 * std::sin(2 * constants::pi / 160) * 200 * 200, 1);
}

TEST(DefectMark, LiesOnItsSurfaceAndIsAsLongAsItsDefect) {
  PlannedSurface planned;
  planned.name = "A01/monopile";
  planned.sizes = MonopileSizes{{0, 0, 0, 20}, 4, {}};
  const std::vector<Surface> surfaces{make_surface(planned, 0.5)};
  std::vector<Defect> defects;
  for (std::uint32_t i = 0; i < 20; ++i) {
    Defect defect;
    defect.number = i;
    defect.kind = i % 2 == 0 ? DefectKind::crack : DefectKind::corrosion;
    defect.patch = 37 * i % surfaces[0].patches.size();
    defect.size_m = 0.1 + 0.05 * i;
    defects.push_back(defect);
  }
  const auto marks = marks_of(defects, surfaces, {5}, 1);
  ASSERT_EQ(marks.size(), 20U);
  for (const DefectMark& mark : marks) {
    const Patch& patch = surfaces[0].patches[defects[mark.defect].patch];
    EXPECT_EQ(mark.thing, 5U);
    EXPECT_EQ(mark.centre_m, patch.centre_m);
    EXPECT_NEAR(dot(mark.along, patch.normal), 0, 1e-9);
    EXPECT_NEAR(length_of(mark.along), 1, 1e-9);
    EXPECT_NEAR(dot(mark.along, mark.down), 0, 1e-9);
    EXPECT_EQ(2 * mark.half_along_m, defects[mark.defect].size_m);
    EXPECT_LE(mark.half_down_m, mark.half_along_m);
    EXPECT_TRUE(mark.holds(mark.centre_m + 0.99 * mark.half_along_m * mark.along));
    EXPECT_FALSE(mark.holds(mark.centre_m + 1.01 * mark.half_along_m * mark.along));
    EXPECT_TRUE(mark.holds(mark.centre_m + 0.99 * mark.half_down_m * mark.down));
    EXPECT_FALSE(mark.holds(mark.centre_m + 1.01 * mark.half_down_m * mark.down));
    EXPECT_FALSE(mark.holds(mark.centre_m - 8.0 * mark.normal)) << "the pile's far side";
  }
}

}  // namespace
}  // namespace slackwater::twin::render_scene_test
