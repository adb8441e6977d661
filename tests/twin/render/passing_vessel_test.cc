#include "twin/render/scene/passing_vessel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "twin/scenario/scenario_traffic.h"

namespace slackwater::twin::passing_vessel_test {
namespace {

struct Extent {
  Triple<double> least{1e9, 1e9, 1e9}, most{-1e9, -1e9, -1e9};
};
Extent extent_of(const TriangleMesh& mesh) {
  Extent extent;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i) {
    const Triple<double> at = mesh.corner_m(i);
    extent.least = {std::min(extent.least.x, at.x), std::min(extent.least.y, at.y),
                    std::min(extent.least.z, at.z)};
    extent.most = {std::max(extent.most.x, at.x), std::max(extent.most.y, at.y),
                   std::max(extent.most.z, at.z)};
  }
  return extent;
}

TEST(PassingVessel, IsAsLongAsItSaysWithItsBowWhereItGoes) {
  TrafficVessel vessel;
  vessel.id = 211000001;
  vessel.length_m = 60;
  vessel.beam_m = 12;
  const SeenThing seen = seen_vessel(vessel, {{500, 300, 0}, {0, 5, 0}}, 0.4);
  EXPECT_EQ(seen.seen_class, SeenClass::vessel);
  EXPECT_EQ(seen.name, "vessel 211000001");
  const Extent extent = extent_of(seen.mesh);
  EXPECT_NEAR(extent.most.y - extent.least.y, 60, 0.01);  // eastward
  EXPECT_NEAR(extent.most.x - extent.least.x, 12, 0.01);
  EXPECT_NEAR(extent.most.z, 0.4 + 3, 0.01);   // draught
  EXPECT_NEAR(extent.least.z, 0.4 - 6, 0.01);  // freeboard
  // The bow is the narrow end.
  std::size_t at_bow = 0, at_stern = 0;
  for (std::size_t i = 0; i < seen.mesh.corners.size(); ++i) {
    const Triple<double> at = seen.mesh.corner_m(i);
    if (std::abs(at.x - 500) < 5) continue;
    at_bow += at.y > 300 + 25 ? 1 : 0;
    at_stern += at.y < 300 - 25 ? 1 : 0;
  }
  EXPECT_EQ(at_bow, 0U);
  EXPECT_GT(at_stern, 0U);
}

TEST(PassingVessel, OfUnknownSizeOrLyingStillIsTheUsual) {
  TrafficVessel vessel;
  vessel.name = "ANNE";
  const SeenThing seen = seen_vessel(vessel, {{0, 0, 0}, {0.05, 0.1, 0}}, 0);
  EXPECT_EQ(seen.name, "ANNE");
  const Extent extent = extent_of(seen.mesh);
  EXPECT_NEAR(extent.most.x - extent.least.x, 20, 0.01);  // north
  EXPECT_NEAR(extent.most.y - extent.least.y, 6, 0.01);
}

TEST(PassingVessel, IsThereWhileItsTrackIsAndWithinReach) {
  MadeUpVessel made_up;
  made_up.mmsi = 211000002;
  made_up.places_m = {{300, -200, 0}, {300, 200, 0}};
  made_up.speed_m_s = 4;  // for 100 s
  const TrafficVessel vessel = vessel_of(made_up, 600);
  const auto at = [&](double t_s, double reach_m) {
    return vessels_in_reach({vessel}, t_s, {0, 0, 0}, reach_m, 0).size();
  };
  EXPECT_EQ(at(50, 1000), 1U);
  EXPECT_EQ(at(50, 100), 0U) << "too far";
  EXPECT_EQ(at(500, 1000), 0U) << "it has gone";
}

}  // namespace
}  // namespace slackwater::twin::passing_vessel_test
