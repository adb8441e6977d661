#include "twin/clearance/keep_clear.h"

#include <gtest/gtest.h>

#include <cstring>

#include "fields/base/random.h"
#include "tests/support/shared_data.h"
#include "twin/control/control_laws.h"
#include "twin/simulate/set_up.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {
namespace {

Autopilot autopilot_of(const std::string& model) {
  const auto data = tests::source_folder() / "data";
  const auto vehicle =
      std::make_shared<const Vehicle>(read_vehicle(vehicle_file(model, data), data));
  ScenarioVehicle entry;
  entry.name = model;
  return *make_agent(vehicle, nullptr, entry, 0.1).autopilot;
}
Measured still_at(double north_m, double east_m, double depth_m) {
  Measured m;
  m.position_m = {north_m, east_m, depth_m};
  m.attitude = attitude_of({0, 0, 0});
  return m;
}
bool same_bits(const Reference& a, const Reference& b) {
  const auto numbers = [](const Reference& r) {
    return std::array<double, 9>{r.position_m.x,   r.position_m.y,   r.position_m.z,
                                 r.velocity_m_s.x, r.velocity_m_s.y, r.velocity_m_s.z,
                                 r.heading.north,  r.heading.east,   r.altitude_m};
  };
  const auto x = numbers(a), y = numbers(b);
  return std::memcmp(x.data(), y.data(), sizeof(x)) == 0 && a.target == b.target &&
         a.vertical == b.vertical && a.is_over_ground == b.is_over_ground;
}
constexpr StandOff stand_off{3, 2, 1, 50, 2};

TEST(AReferenceThatKeepsClear, IsTheSameToTheLastBit) {
  const Autopilot a = autopilot_of("bluerov2_heavy");
  const Handling h = handling_of(a, 0.4, 0.2, 0.2, false, 0.1);
  const std::vector<Structure> structures{Cylinder{500, 0, 3, -20, 60}};
  std::vector<Craft> craft{Craft{}};
  for (int seed = 0; seed < 100; ++seed) {
    Rng rng(7, "reference/" + std::to_string(seed));
    Reference wanted;
    wanted.target = static_cast<Target>(seed % 3);
    wanted.vertical = static_cast<Vertical>(seed % 2);
    wanted.position_m = {rng.uniform(-50, 50), rng.uniform(-50, 50), rng.uniform(0, 30)};
    wanted.velocity_m_s = {rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-1, 1)};
    wanted.heading = course_of(rng.uniform(0, 6));
    wanted.altitude_m = rng.uniform(1, 9);
    const Measured measured = still_at(rng.uniform(-50, 50), 0, rng.uniform(0, 30));
    ClearanceState state;
    EXPECT_TRUE(same_bits(wanted, keep_clear(h, stand_off, {craft, 0, structures, {}, {}}, a,
                                             measured, wanted, 0.05, state)));
  }
}

TEST(AReferenceIntoAStructure, BecomesAStationThatIsGoneForAtTheClearSpeed) {
  for (const char* model : {"bluerov2_heavy", "x500", "wamv16", "ctv24"}) {
    const Autopilot a = autopilot_of(model);
    const Handling h = handling_of(a, 0.4, 0.2, 0.2, false, 0.1);
    const std::vector<Structure> structures{Cylinder{12, 0, 3, -200, 600}};
    std::vector<Craft> craft{Craft{}};
    Reference wanted;
    wanted.target = Target::path;
    const double room_m = 12 - 3 - 2 - 0.4 - h.stray_m;
    wanted.velocity_m_s = {speed_for_way_m_s(h, 1.5 * room_m, 0), 0, 0};
    const Measured measured = still_at(0, 0, 0);
    ClearanceState state;
    const Reference clear =
        keep_clear(h, stand_off, {craft, 0, structures, {}, {}}, a, measured, wanted, 0.05, state);
    ASSERT_EQ(clear.target, Target::station) << model;
    Outset outset;
    outset.r = rotation_of(measured.attitude);
    const Triple<double> asked = wanted_velocity(a, measured, clear, outset);
    EXPECT_LE(stopping_way_m(h, asked.x), room_m) << model;
    if (h.manner == Manner::turns) {
      EXPECT_GT(std::hypot(asked.x, asked.y), 0.1) << model << " goes round it at once";
      continue;
    }
    EXPECT_GT(stopping_way_m(h, asked.x), 0.5 * room_m) << model;
    EXPECT_NEAR(asked.y, 0, 1e-9) << model;
  }
}

TEST(AReferenceBelowAnotherVehicle, IsHeldAboveIt) {
  const Autopilot a = autopilot_of("bluerov2_heavy");
  const Handling h = handling_of(a, 0.4, 0.2, 0.2, false, 0.1);
  OwnMotion other;
  other.depth_m = 12;
  const Measured measured = still_at(0, 0, 8);
  OwnMotion own;
  own.depth_m = 8;
  std::vector<Craft> craft{craft_of(h, own, {}), craft_of(h, other, {})};
  Reference wanted;
  wanted.position_m = {0, 0, 20};
  ClearanceState state;
  const Reference clear =
      keep_clear(h, stand_off, {craft, 0, {}, {}, {}}, a, measured, wanted, 0.05, state);
  // 3.6 m lie between the hulls, 2 m must: half of what is left.
  EXPECT_NEAR(clear.position_m.z, 8.8, 1e-9);
  EXPECT_EQ(clear.position_m.x, 0);
  EXPECT_EQ(clear.target, Target::station);
}

}  // namespace
}  // namespace slackwater::twin
