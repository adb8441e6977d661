#include "twin/clearance/keep_clear.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "fields/base/numbers/random.h"
#include "tests/support/shared_data.h"
#include "twin/control/control_laws.h"
#include "twin/run/set_up.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin::keep_clear_test {
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

constexpr std::array four_models{"bluerov2_heavy", "x500", "wamv16", "ctv24"};

/// A vehicle at rest whose reference leads north into a pile.
struct IntoAPile {
  Autopilot autopilot;
  Handling handling;
  double more_s = 0;  ///< of reaction, that it plans for
  static constexpr double dt_s = 0.05;
  static constexpr double room_m = 2;  ///< from its hull, and what it strays, to the stand-off

  explicit IntoAPile(const char* model)
      : autopilot(autopilot_of(model)),
        handling(handling_of(autopilot, 0.4, 0.2, 0.2, false, 0.1)),
        more_s(handling.early * handling.reaction_s + 2 * dt_s) {}
  /// The velocity that the reference asks for which it becomes: a station, for all four.
  [[nodiscard]] Triple<double> asked_m_s(double wished_m_s) const {
    constexpr double radius_m = 3;
    const double north_m =
        room_m + handling.stray_m + handling.radius_m + stand_off.structure_m + radius_m;
    const std::vector<Structure> structures{Cylinder{north_m, 0, radius_m, -200, 600}};
    const std::vector<Craft> craft{Craft{}};
    Reference wanted;
    wanted.target = Target::path;
    wanted.velocity_m_s = {wished_m_s, 0, 0};
    const Measured measured = still_at(0, 0, 0);
    ClearanceState state;
    const Reference clear = keep_clear(handling, stand_off, {craft, 0, structures, {}, {}},
                                       autopilot, measured, wanted, dt_s, state);
    EXPECT_EQ(clear.target, Target::station);
    EXPECT_EQ(state.alarms, 0);
    Outset outset;
    outset.r = rotation_of(measured.attitude);
    return wanted_velocity(autopilot, measured, clear, outset);
  }
};

TEST(AReferenceIntoAStructure, BecomesAStationThatIsGoneForAtTheClearSpeed) {
  for (const char* model : four_models) {
    const IntoAPile pile(model);
    const Handling& h = pile.handling;
    // As fast as it plans for one and a half times its room: what is clear is more than half of its
    // way, so that it goes on as far as that.
    const Triple<double> asked =
        pile.asked_m_s(speed_for_way_m_s(h, 1.5 * pile.room_m, pile.more_s));
    EXPECT_NEAR(asked.x, speed_for_way_m_s(h, pile.room_m, pile.more_s), 1e-9) << model;
    EXPECT_NEAR(asked.y, 0, 1e-9) << model;
    EXPECT_GT(asked.x, 0) << model;
    // It is told to stop as late as its reaction and the share of it that it plans ahead.
    EXPECT_NEAR(stopping_way_m(h, asked.x) + asked.x * pile.more_s, pile.room_m, 1e-9) << model;
  }
}

TEST(AReferenceFarIntoAStructure, BecomesAStationBesideItToStarboardAtTheWishedSpeed) {
  for (const char* model : four_models) {
    const IntoAPile pile(model);
    // Three times its room: it goes round at once, along the plane before the pile.
    const double wished_m_s = speed_for_way_m_s(pile.handling, 3 * pile.room_m, pile.more_s);
    ASSERT_LT(wished_m_s, pile.handling.most_speed_m_s) << model;
    const Triple<double> asked = pile.asked_m_s(wished_m_s);
    EXPECT_NEAR(asked.x, 0, 1e-9) << model;
    EXPECT_NEAR(asked.y, wished_m_s, 1e-9) << model;
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
}  // namespace slackwater::twin::keep_clear_test
