#include "twin/clearance/clear_way.h"

#include <gtest/gtest.h>

#include "fields/base/numbers/random.h"
#include "tests/bench/counted_allocations.h"

namespace slackwater::twin::clear_way_test {
namespace {

Handling rov() {
  Handling h;
  h.deceleration_m_s2 = 0.25;
  h.acceleration_m_s2 = 0.5;
  h.reaction_s = 2;
  h.most_speed_m_s = 1.5;
  h.sure_speed_m_s = 0.75;
  h.vertical_deceleration_m_s2 = 0.25;
  h.radius_m = 0.4;
  h.above_m = h.below_m = 0.2;
  return h;
}
Handling vessel() {
  Handling h = rov();
  h.radius_m = 13;
  h.above_m = 8;
  h.below_m = 2;
  h.most_speed_m_s = 10;
  h.sure_speed_m_s = 5;
  h.is_afloat = true;
  return h;
}
constexpr StandOff stand_off{3, 2, 1, 50, 2};
constexpr double dt_s = 0.1;

OwnMotion at(double north_m, double east_m, const Planar& velocity_m_s = {}, double depth_m = 10) {
  OwnMotion own;
  own.position_m = {north_m, east_m};
  own.velocity_m_s = velocity_m_s;
  own.depth_m = depth_m;
  return own;
}

/// One vehicle among what is around it.
struct Scene {
  std::vector<Craft> craft;
  std::vector<Structure> structures;
  std::vector<Line> lines;
  std::vector<Passer> passers;
  ClearanceState state;

  ClearWay way_for(const Handling& h, const OwnMotion& own, const Wish& wish,
                   std::size_t place = 0) {
    std::vector<Craft> all = craft;
    all.insert(all.begin() + static_cast<std::ptrdiff_t>(place), craft_of(h, own, state));
    return clear_way(h, stand_off, {all, place, structures, lines, passers}, own, wish, dt_s,
                     state);
  }
  ClearWay way(const Handling& h, const OwnMotion& own, const Planar& wish_m_s, double down_m_s = 0,
               std::size_t place = 0) {
    return way_for(h, own, Wish{wish_m_s, down_m_s}, place);
  }
};

TEST(AStoppingClaim, ShrinksWithinItselfAsTheVehicleStops) {
  for (int seed = 0; seed < 100; ++seed) {
    Rng rng(7, "claim/" + std::to_string(seed));
    Handling h = rov();
    h.reaction_s = 0;  // the reaction is over
    h.deceleration_m_s2 = rng.uniform(0.05, 3);
    OwnMotion own =
        at(rng.uniform(-9, 9), rng.uniform(-9, 9), {rng.uniform(-5, 5), rng.uniform(-5, 5)});
    const Claim first = claim_of(h, own);
    const Planar ahead = unit_of(own.velocity_m_s, {});
    while (size_of(own.velocity_m_s) > 0) {  // a hundredth of a second at a time
      const double speed = size_of(own.velocity_m_s);
      const double slower = std::max(speed - 0.01 * h.deceleration_m_s2, 0.0);
      own.position_m = own.position_m + (0.005 * (speed + slower)) * ahead;
      own.velocity_m_s = slower * ahead;
      const Claim now = claim_of(h, own);
      EXPECT_LT(size_of(now.stretch.to - nearest_on(first.stretch, now.stretch.to)), 1e-3);
      EXPECT_LT(size_of(now.stretch.from - nearest_on(first.stretch, now.stretch.from)), 1e-3);
    }
  }
}

TEST(ACirclingClaim, StaysWhereItIsAsTheVehicleCircles) {
  Handling h = rov();
  h.manner = Manner::circles;
  h.turning_radius_m = 20;
  OwnMotion own = at(3, 4, {1, 0});
  const Claim first = claim_of(h, own);
  const Planar centre{3, 24};
  for (double angle = 0; angle < 7; angle += 0.1) {
    own.bow = {std::cos(angle), std::sin(angle)};
    own.position_m = centre - 20 * to_the_right(own.bow);
    own.velocity_m_s = own.bow;
    EXPECT_LT(size_of(claim_of(h, own).stretch.from - first.stretch.from), 1e-9);
    EXPECT_LT(size_of(own.position_m - first.stretch.from), first.radius_m);
  }
}

TEST(ASpeedForAWay, IsThatWhoseStoppingWayItIs) {
  const Handling h = rov();
  for (const double speed : {0.0, 0.01, 0.3, 1.5, 8.0})
    EXPECT_NEAR(speed_for_way_m_s(h, stopping_way_m(h, speed), 0), speed, 1e-12);
}

TEST(TwoVehicles, LayTheSamePlanesBetweenThemAndTheStandOffLiesBetweenThese) {
  for (int seed = 0; seed < 200; ++seed) {
    Rng rng(7, "planes/" + std::to_string(seed));
    const auto any = [&] {
      return at(rng.uniform(-30, 30), rng.uniform(-30, 30),
                {rng.uniform(-1.5, 1.5), rng.uniform(-1.5, 1.5)});
    };
    const OwnMotion a = any(), b = any();
    const Craft craft_a = craft_of(rov(), a, {}), craft_b = craft_of(rov(), b, {});
    const Handling h = rov();
    Cell cell_a, cell_b;
    keep_clear_of(craft_b, 1, craft_a, {&h, stand_off, craft_a.claim, a.position_m, 1e3}, cell_a);
    keep_clear_of(craft_a, 0, craft_b, {&h, stand_off, craft_b.claim, b.position_m, 1e3}, cell_b);
    ASSERT_EQ(cell_a.planes().size(), 1U);
    ASSERT_EQ(cell_b.planes().size(), 1U);
    const Plane &of_a = cell_a.planes()[0], &of_b = cell_b.planes()[0];
    EXPECT_NEAR(dot(of_a.normal, of_b.normal), -1, 1e-9) << seed;
    EXPECT_NEAR(-of_b.limit_m - of_a.limit_m,
                stand_off.craft_m + craft_a.claim.radius_m + craft_b.claim.radius_m, 1e-9)
        << seed;
    const NearestPlaces near = nearest_places(craft_a.claim.stretch, craft_b.claim.stretch);
    if (size_of(near.on_a - near.on_b) < 7) continue;
    EXPECT_GE(of_a.room_m(craft_a.claim.stretch), 0) << "to stop is always allowed";
    EXPECT_GE(of_b.room_m(craft_b.claim.stretch), 0);
  }
}

TEST(ABrakingVehicle, ThatCanStopBeforeAStructureStillCanAsItsPlaneTurns) {
  // The distance to a convex body is convex along the way in which it stops.
  int near = 0;
  for (int seed = 0; seed < 500; ++seed) {
    Rng rng(7, "structure/" + std::to_string(seed));
    Handling h = rov();
    h.reaction_s = 0;
    OwnMotion own =
        at(rng.uniform(-20, 20), rng.uniform(-20, 20), {rng.uniform(-3, 3), rng.uniform(-3, 3)});
    Structure structure = Cylinder{0, 0, rng.uniform(1, 6), -10, 40};
    if (seed % 2 == 0)
      structure = box_of({0, 0, 10}, {rng.uniform(1, 6), rng.uniform(1, 6), 30}, rng.uniform(0, 6));
    const auto room_m = [&](const OwnMotion& now) {
      Cell cell;
      const Claim claim = claim_of(h, now);
      keep_clear_of(structure, {&h, stand_off, claim, now.position_m, 1e3}, cell);
      return cell.room_m(claim);
    };
    const double first_m = room_m(own);
    if (first_m < 0) continue;
    const Planar ahead = unit_of(own.velocity_m_s, {});
    double speed = size_of(own.velocity_m_s);
    while (speed > 0) {
      const double slower = std::max(speed - 0.02 * h.deceleration_m_s2, 0.0);
      own.position_m = own.position_m + (0.01 * (speed + slower)) * ahead;
      own.velocity_m_s = slower * ahead;
      speed = slower;
      ASSERT_GE(room_m(own), -1e-9) << seed;
    }
    near += first_m < 3 ? 1 : 0;
    EXPECT_GE(signed_distance_m(structure, {own.position_m.north, own.position_m.east, 10}),
              stand_off.structure_m + h.radius_m - 1e-9);
  }
  EXPECT_GT(near, 20);
}

TEST(AWishThatKeepsClear, IsLeftAsItIs) {
  Scene scene;
  scene.structures.push_back(Cylinder{30, 0, 3, -20, 60});
  const ClearWay way = scene.way(rov(), at(0, 0, {1, 0}), {1, 0});
  EXPECT_TRUE(way.is_as_wished_aside && way.is_as_wished_in_depth);
  EXPECT_EQ(scene.state.alarms, 0);
  EXPECT_EQ(scene.state.changed_s, 0);
}

TEST(AWishIntoAStructure, IsSlowedToWhatStillStops) {
  Scene scene;
  scene.structures.push_back(Cylinder{10, 0, 3, -20, 60});
  const ClearWay way = scene.way(rov(), at(0, 0, {0.4, 0}), {1.5, 0});
  ASSERT_FALSE(way.is_as_wished_aside);
  const double room_m = 10 - 3 - 2 - 0.4;
  EXPECT_LT(stopping_way_m(rov(), size_of(way.velocity_m_s)), room_m);
  EXPECT_GT(size_of(way.velocity_m_s), 0);
}

TEST(AWishIntoAStructure, LeadsRoundItOnlyToAPlaceBeyondItThatIsClear) {
  // Radius 3 at the origin; the origin of the vehicle comes no nearer to its axis than 5.4.
  const Cylinder pile{.north_m = 0, .east_m = 0, .radius_m = 3, .top_m = -20, .bottom_m = 60};
  struct Case {
    const char* what;
    Planar place_m;
    Planar goes_m_s;
    bool leads_round;
  };
  for (const Case& c : {Case{"beyond it", {0, -9}, {}, true},
                        {"on its way past it", {0, 5.5}, {0, -2}, true},
                        {"at its face", {0, 4.2}, {}, false},
                        {"at its far face", {0, -4.2}, {}, false},
                        {"half a metre ahead", {0, 5.45}, {}, false},
                        {"along it", {0, 5.5}, {0.3, 0}, false}}) {
    SCOPED_TRACE(c.what);
    Scene scene;
    scene.structures = {pile};
    Wish wish{{0, -0.5}, 0};
    wish.place_m = c.place_m;
    wish.place_m_s = c.goes_m_s;
    for (int i = 0; i < 50; ++i) (void)scene.way_for(rov(), at(0, 5.5), wish);
    EXPECT_EQ(scene.state.side != 0, c.leads_round);
  }
}

TEST(AnRovUnderAVessel, IsClearOfItByItsDepth) {
  Scene scene;
  scene.craft.push_back(craft_of(vessel(), at(5, 0, {}, 0), {}));
  EXPECT_TRUE(scene.way(rov(), at(0, 0, {1, 0}, 20), {1, 0}).is_as_wished_aside);
  // Its keel lies at 2 m, and 2 m below that the ROV's top, 0.2 m above its origin.
  ClearWay way = scene.way(rov(), at(0, 0, {}, 8), {}, -0.1);
  EXPECT_TRUE(way.is_as_wished_in_depth);
  way = scene.way(rov(), at(0, 0, {0, 0}, 4.3), {}, -0.5);
  EXPECT_FALSE(way.is_as_wished_in_depth);
  EXPECT_NEAR(way.least_depth_m, 4.2, 1e-9);
  // The vessel is not held up by what is deep below it.
  Scene other;
  other.craft.push_back(craft_of(rov(), at(5, 0, {}, 20), {}));
  EXPECT_TRUE(other.way(vessel(), at(0, 0, {1, 0}, 0), {1, 0}).is_as_wished_aside);
  Scene shallow;
  shallow.craft.push_back(craft_of(rov(), at(25, 0, {}, 2), {}));
  EXPECT_FALSE(shallow.way(vessel(), at(0, 0, {3, 0}, 0), {3, 0}).is_as_wished_aside);
}

/// A line that hangs down at (north, east).
std::array<Triple<double>, tether_nodes> hanging(double north_m, double east_m) {
  std::array<Triple<double>, tether_nodes> nodes;
  for (std::size_t i = 0; i < nodes.size(); ++i) nodes[i] = {north_m, east_m, double(i)};
  return nodes;
}

TEST(ALine, IsCutByNoOneInItsDepthsAndCrossedBelowThem) {
  const auto nodes = hanging(5, 0);
  Scene scene;
  scene.lines.push_back({nodes, 7, true});
  EXPECT_FALSE(scene.way(rov(), at(0, 0, {1, 0}, 8), {1, 0}).is_as_wished_aside);
  EXPECT_TRUE(scene.way(rov(), at(0, 0, {1, 0}, 30), {1, 0}).is_as_wished_aside);
  scene.lines[0].is_whole = false;
  EXPECT_TRUE(scene.way(rov(), at(0, 0, {1, 0}, 8), {1, 0}).is_as_wished_aside);
}

TEST(ALineOfItsOwn, StopsACraftAfloatButForItsAttachment) {
  Handling h = vessel();
  h.radius_m = 2;
  auto nodes = hanging(12, 0);
  nodes.back() = {1, 0, 0};  // from 12 m ahead back to the bow
  Scene scene;
  scene.lines.push_back({nodes, 0, true});
  EXPECT_FALSE(scene.way(h, at(0, 0, {3, 0}, 0), {3, 0}).is_as_wished_aside);
  EXPECT_TRUE(scene.way(rov(), at(0, 0, {1, 0}, 5), {1, 0}).is_as_wished_aside)
      << "an ROV drags it behind as it likes";
  for (Triple<double>& node : nodes) node = {1.5, 0, 0};
  EXPECT_TRUE(scene.way(h, at(0, 0, {0.1, 0}, 0), {0.1, 0}).is_as_wished_aside);
}

Passer ship(double along_m, double across_m, double speed_m_s) {
  return {{-along_m, across_m}, {speed_m_s, 0}, 60, 9, -30, 8};
}

TEST(AVesselsWay, IsNotEnteredWithinTheTimeToLeaveIt) {
  const double breadth_m = 50 + 9 + 0.4;
  const double leaving_s = leaving_time_s(rov(), breadth_m);
  Scene near, far;
  near.passers.push_back(ship(60 + 5 * leaving_s, 0, 5));
  far.passers.push_back(ship(60 + breadth_m + 5 * leaving_s + 20, 0, 5));
  const OwnMotion own = at(0, -breadth_m - 1.5, {0, 0.3});
  EXPECT_FALSE(near.way(rov(), own, {0, 1.5}).is_as_wished_aside);
  EXPECT_TRUE(far.way(rov(), own, {0, 1.5}).is_as_wished_aside);
  EXPECT_EQ(near.state.alarms, 0);
}

TEST(AVesselsWay, IsLeftByTheNearerSideAtFullSpeed) {
  Scene scene;
  scene.passers.push_back(ship(60 + 5 * 150, 10, 5));
  const ClearWay way = scene.way(rov(), at(0, 0), {});
  ASSERT_FALSE(way.is_as_wished_aside);
  EXPECT_NEAR(way.velocity_m_s.east, -1.5, 0.01);
  EXPECT_NEAR(way.velocity_m_s.north, 0, 0.01);
  EXPECT_EQ(scene.state.alarms, 0) << "there is time";
}

TEST(AVesselWithoutWarning, IsAnAlarm) {
  Scene scene;
  scene.passers.push_back(ship(60 + 5 * 20, 10, 5));
  (void)scene.way(rov(), at(0, 0), {});
  EXPECT_EQ(scene.state.alarms, 1);
  (void)scene.way(rov(), at(0, 0), {});
  EXPECT_EQ(scene.state.alarms, 1) << "once";
}

TEST(AVehicleThatIsPlacedTooNear, RaisesAnAlarmAndMovesOff) {
  Scene scene;
  scene.structures.push_back(Cylinder{4, 0, 3, -20, 60});
  const ClearWay way = scene.way(rov(), at(0, 0), {});
  EXPECT_EQ(scene.state.alarms, 1);
  EXPECT_LT(way.velocity_m_s.north, 0);
  EXPECT_LT(scene.state.slack_m, 0);
}

TEST(AnAlarm, IsCountedByWhatItBeganWith) {
  const auto nodes = hanging(0.5, 0);
  const auto raised = [&](AlarmCause cause, const auto& put) {
    Scene scene;
    put(scene);
    // Twice: it goes on, and is one alarm.
    for (int i = 0; i < 2; ++i) (void)scene.way(rov(), at(0, 0), {1.5, 0});
    std::array<double, alarm_causes> expected{};
    expected[static_cast<std::size_t>(cause)] = 1;
    EXPECT_EQ(scene.state.alarms_from, expected) << name_of(cause);
    EXPECT_EQ(scene.state.alarms, 1) << name_of(cause);
  };
  raised(AlarmCause::structure, [](Scene& s) { s.structures = {Cylinder{4, 0, 3, -20, 60}}; });
  raised(AlarmCause::structure, [](Scene& s) {
    s.structures = {box_of({4, 0, 10}, {3, 9, 30}, 0)};
  });
  raised(AlarmCause::vehicle, [](Scene& s) { s.craft = {craft_of(rov(), at(3, 0), {})}; });
  raised(AlarmCause::line, [&](Scene& s) { s.lines = {{nodes, 7, true}}; });
  Passer drifts = ship(0, 60, 0);
  raised(AlarmCause::vessel, [&](Scene& s) { s.passers = {drifts}; });
  drifts.is_of_run = true;
  raised(AlarmCause::vehicle, [&](Scene& s) { s.passers = {drifts}; });
  raised(AlarmCause::no_warning, [](Scene& s) { s.passers = {ship(60 + 5 * 20, 10, 5)}; });
  // Far enough off each of them; one more than there are planes.
  raised(AlarmCause::crowded, [](Scene& s) {
    for (std::size_t i = 0; i <= most_planes; ++i) {
      const double angle = 6.28 * double(i) / double(most_planes);
      s.structures.push_back(Cylinder{6 * std::cos(angle), 6 * std::sin(angle), 0.1, -20, 60});
    }
  });
  // Of two it is the one that is farther within.
  raised(AlarmCause::vehicle, [](Scene& s) {
    s.structures = {Cylinder{5, 0, 3, -20, 60}};
    s.craft = {craft_of(rov(), at(-1, 0), {})};
  });
}

TEST(ACarrierAndWhatItCarries, HoldNobodyUpAndRaiseNoAlarmHoweverNear) {
  const OwnMotion below = at(0, 0, {1, 0}, 2);
  Handling under_way = vessel();
  std::vector<Craft> craft{craft_of(under_way, at(1, 0, {1, 0}, 0), {}),
                           craft_of(rov(), below, {})};
  const auto looked = [&](std::size_t own) {
    const Handling& h = own == 0 ? under_way : rov();
    const OwnMotion& motion = own == 0 ? at(1, 0, {1, 0}, 0) : below;
    ClearanceState state;
    const ClearWay way =
        clear_way(h, stand_off, {craft, own, {}, {}, {}}, motion, {{1, 0}, 0}, dt_s, state);
    return std::pair{state.alarms, way.is_as_wished_aside && way.is_as_wished_in_depth};
  };
  // Strangers, so near.
  EXPECT_EQ(looked(0), (std::pair{1.0, false}));
  EXPECT_EQ(looked(1), (std::pair{1.0, false}));
  craft[1].carrier = 0;
  EXPECT_EQ(looked(0), (std::pair{0.0, true}));
  EXPECT_EQ(looked(1), (std::pair{0.0, true}));
  // Another's carrier is a stranger.
  craft.push_back(craft_of(vessel(), at(400, 0, {}, 0), {}));
  craft[1].carrier = 2;
  EXPECT_EQ(looked(1), (std::pair{1.0, false}));
  // On its deck it is not there for anybody.
  craft[1].carrier = Craft::nobody;
  craft[1].is_there = false;
  EXPECT_EQ(looked(0), (std::pair{0.0, true}));
}

TEST(RightOfWay, IsGivenByTheLaterInTheRunSquareToTheOthersWish) {
  Craft first = craft_of(rov(), at(-8, 0), {});
  first.wish_m = {6, 0};
  first.hindered_by = 1;
  Scene scene;
  scene.craft.push_back(first);
  const ClearWay way = scene.way(rov(), at(0, 0.5), {}, 0, 1);
  ASSERT_FALSE(way.is_as_wished_aside);
  EXPECT_GT(way.velocity_m_s.east, 0.5);
  EXPECT_NEAR(way.velocity_m_s.north, 0, 0.1);
  first.hindered_by = 0;
  Scene other;
  other.craft.push_back(first);
  EXPECT_TRUE(other.way(rov(), at(0, 0.5), {}, 0, 0).is_as_wished_aside)
      << "the first in the run stays";
}

TEST(ACraftThatTurns, PointsItsBowOutBeforeItGoes) {
  Handling h = vessel();
  h.manner = Manner::turns;
  h.radius_m = 2;
  h.most_yaw_rate_rad_s = 0.2;
  Scene scene;
  scene.structures.push_back(Cylinder{7, 0, 3, -20, 60});
  OwnMotion own = at(0, 0, {}, 0);
  own.bow = {0.8, 0.6};
  const ClearWay way = scene.way(h, own, {2, 0.6});
  ASSERT_FALSE(way.is_as_wished_aside);
  EXPECT_TRUE(way.only_turns);
  EXPECT_GT(std::abs(way.velocity_m_s.east), std::abs(way.velocity_m_s.north));
}

TEST(AnAuv, CirclesWhereItsWayIsBarred) {
  Handling h = rov();
  h.manner = Manner::circles;
  h.turning_radius_m = 20;
  h.most_yaw_rate_rad_s = 0.06;
  h.most_speed_m_s = 1;
  h.reaction_s = 1;
  Scene scene;
  scene.structures.push_back(box_of({44.0, 0, 10}, {10, 200, 60}, 0));
  ClearWay way = scene.way(h, at(-30, 0, {1, 0}), {1, 0});
  EXPECT_TRUE(way.is_as_wished_aside);
  // The circle, 20 m ahead of its middle, and reaction and hull reach to 2 m before the wall.
  way = scene.way(h, at(34 - 2 - 20 - 1.4 - 0.05, 0, {1, 0}), {1, 0});
  EXPECT_FALSE(way.is_as_wished_aside);
}

TEST(KeepingClear, AllocatesNothing) {
  const auto nodes = hanging(12, 3);
  std::vector<Craft> craft{craft_of(rov(), at(0, 0, {1, 0}), {}),
                           craft_of(rov(), at(9, 0, {-1, 0}), {})};
  const std::vector<Structure> structures{Cylinder{10, 8, 3, -20, 60},
                                          box_of({-9, 3, 10}, {2, 2, 20}, 1)};
  const std::vector<Line> lines{{nodes, 7, true}};
  const std::vector<Passer> passers{ship(900, 10, 5)};
  const Lookout lookout{craft, 0, structures, lines, passers};
  const Handling h = rov();
  ClearanceState state;
  const std::size_t before = bench::allocations();
  for (int i = 0; i < 100; ++i)
    (void)clear_way(h, stand_off, lookout, at(0, 0.01 * i, {1, 0}), {{1, 0.2}, 0}, dt_s, state);
  EXPECT_EQ(bench::allocations(), before);
}

}  // namespace
}  // namespace slackwater::twin::clear_way_test
