#include <gtest/gtest.h>

#include <fstream>

#include "tests/support/temporary_folder.h"
#include "twin/render/scene/scene_of_run.h"

namespace slackwater::twin::vehicle_shape_test {
namespace {

/// Where the middle of a craft of 1 m height lies below its origin.
double middle_m(const std::string& hulls) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path file = folder / "craft.yaml";
  std::ofstream(file) << "kind: usv\ndimensions_m: {length: 2, width: 1, height: 1}\n" << hulls;
  return read_vehicle_shape(file).middle_m.z;
}

TEST(VehicleShape, StandsOnTheLowestOfItsHulls) {
  EXPECT_EQ(middle_m("hulls: {keel_z_m: 0.25}\n"), -0.25);
  EXPECT_EQ(middle_m("hulls: [{keel_z_m: -0.1}, {keel_z_m: 0.25}, {keel_z_m: 0.1}]\n"), -0.25);
  EXPECT_EQ(middle_m(""), 0);
}

}  // namespace
}  // namespace slackwater::twin::vehicle_shape_test
