#include "twin/render/scene/turning_rotor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "tests/support/shared_data.h"

namespace slackwater::twin::turning_rotor_test {
namespace {

const Turbine& nrel() {
  static const Turbine turbine =
      Turbine::load(slackwater::tests::source_folder() / "data/turbines/nrel_5mw.yaml");
  return turbine;
}

/// The corner that is farthest from a place.
Triple<double> tip_m(const TriangleMesh& mesh, const Triple<double>& from_m) {
  Triple<double> tip = from_m;
  for (std::size_t i = 0; i < mesh.corners.size(); ++i)
    if (length_of(mesh.corner_m(i) - from_m) > length_of(tip - from_m)) tip = mesh.corner_m(i);
  return tip;
}

/// A west wind: it blows to the east.
RunningTurbine in_west_wind(double speed_m_s) { return {100, 200, -12, 0, speed_m_s}; }

TEST(TurningRotor, TurnsWithTheWindWithinItsLimits) {
  const double radius_m = 63;
  EXPECT_NEAR(rotor_speed_rad_s(nrel(), 8), 8 * 8 / radius_m, 1e-12);
  EXPECT_NEAR(rotor_speed_rad_s(nrel(), 20), 90 / radius_m, 1e-12);
  EXPECT_EQ(rotor_speed_rad_s(nrel(), 2), 0);
  EXPECT_EQ(rotor_speed_rad_s(nrel(), 26), 0);
}

TEST(TurningRotor, HasItsPartsByTheirNamesAndClasses) {
  const auto things = seen_turbine(nrel(), in_west_wind(8), 3, "turbine 1");
  ASSERT_EQ(things.size(), 5U);
  EXPECT_EQ(things[0].seen_class, SeenClass::tower);
  EXPECT_EQ(things[1].seen_class, SeenClass::nacelle);
  EXPECT_EQ(things[4].seen_class, SeenClass::blade);
  EXPECT_EQ(things[4].name, "turbine 1/blade 3");
  // A foundation that is drawn up to the hub is its tower, too.
  RunningTurbine to_the_hub = in_west_wind(8);
  to_the_hub.foot_m = -90;
  EXPECT_EQ(seen_turbine(nrel(), to_the_hub, 3, "turbine 1").size(), 4U);
}

TEST(TurningRotor, StandsUpwindOfItsTowerAndTurnsClockwiseAsSeenFromThere) {
  const Triple<double> hub_m{100, 200 - 5, -90};  // 5 m of overhang; upwind is west
  const double quarter_s = 0.5 * constants::pi / rotor_speed_rad_s(nrel(), 8);
  const auto at = [&](double t_s) {
    return tip_m(seen_turbine(nrel(), in_west_wind(8), t_s, "t")[2].mesh, hub_m);
  };
  const Triple<double> up = at(0), aside = at(quarter_s);
  EXPECT_NEAR(up.z, -90 - 63, 0.1);
  EXPECT_NEAR(up.y, hub_m.y, 1.42);
  // Who stands in the west and looks east has the south on the right.
  EXPECT_NEAR(aside.x, 100 - 63, 0.1);
  EXPECT_NEAR(aside.z, -90, 1.42) << "the chord of the tip";
  const Triple<double> round = at(4 * quarter_s);
  EXPECT_NEAR(length_of(round - up), 0, 0.01);
}

TEST(TurningRotor, StandsStillInACalmAndItsTowerOnItsFoundation) {
  const auto now = seen_turbine(nrel(), {0, 0, -12, 0, 0}, 100, "t");
  const auto later = seen_turbine(nrel(), {0, 0, -12, 0, 0}, 200, "t");
  EXPECT_EQ(now[3].mesh.corners, later[3].mesh.corners);
  double lowest_m = -1000;
  for (std::size_t i = 0; i < now[0].mesh.corners.size(); ++i)
    lowest_m = std::max(lowest_m, now[0].mesh.corner_m(i).z);
  EXPECT_NEAR(lowest_m, -12, 1e-4);
}

}  // namespace
}  // namespace slackwater::twin::turning_rotor_test
