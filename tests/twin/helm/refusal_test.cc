#include "twin/helm/refusal.h"

#include <cmath>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::twin::refusal_test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double inf = std::numeric_limits<double>::infinity();

/// One of each kind, about a pile, in 60 m of water.
const ReadyRun& fleet() {
  static const ReadyRun ready = tests::ready_of(
      "name: test\nseed: 7\nduration: 30min\nwater: {made_up: {depth_m: 60}}\n"
      "structures: [{name: pile, kind: cylinder, north_m: 100, east_m: 0, diameter_m: 10, "
      "top_height_m: 20, bottom_depth_m: 60}]\nvehicles:\n"
      "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, depth_m: 10}, tasks: "
      "[{do: hold}]}\n"
      "  - {name: auv, model: lrauv_tethys, start: {north_m: 0, east_m: 50, depth_m: 10}, tasks: "
      "[{do: hold}]}\n"
      "  - {name: usv, model: wamv16, start: {north_m: 0, east_m: 99, depth_m: 0}, tasks: [{do: "
      "hold}]}\n"
      "  - {name: uav, model: x500, start: {north_m: 0, east_m: 150, height_m: 30}, tasks: [{do: "
      "hold}]}\n");
  return ready;
}
enum Place : std::size_t { rov, auv, usv, uav };

struct Asking {
  Place place = rov;
  Standing standing{};
  std::optional<std::uint64_t> last{};
  double now_s = 10;
};

std::optional<Refusal> answer(CommandWhat what, const Asking& asking = {}) {
  Command command{0, asking.place, std::move(what), "test", 5, 10};
  return refusal_of(command, fleet().agents[asking.place], asking.standing, asking.last,
                    asking.now_s);
}

/// Refused for that reason, in words that say what was found and what to do.
void expect_no(const std::optional<Refusal>& answer, RefusalReason reason,
               std::initializer_list<const char*> words) {
  ASSERT_TRUE(answer) << name_of(reason);
  EXPECT_STREQ(name_of(answer->reason), name_of(reason)) << answer->text;
  for (const char* word : words)
    EXPECT_NE(answer->text.find(word), std::string::npos) << answer->text << " has no " << word;
}

Reroute to(double north_m, double east_m, double down_m, double speed_m_s = 0) {
  return Reroute{{{{north_m, east_m, down_m}, speed_m_s}}};
}

/// A turn of longitude away, and where a longitude has no digits left behind its point.
TEST(Refusal, NoPlaceIsFurtherAwayThanAVehicleCanBe) {
  for (const double east_m : {23'036'700.0, 69'110'100.0, -23'036'700.0, 1e25, 1e200, 1e308}) {
    expect_no(answer(to(0, east_m, 30)), RefusalReason::no_place, {"waypoint 1", "1e+06 m"});
    expect_no(answer(to(east_m, 0, 30)), RefusalReason::no_place, {"waypoint 1", "1e+06 m"});
  }
}

TEST(Refusal, WhatCanBeDoneIsNotRefused) {
  EXPECT_FALSE(answer(SetVelocity{{0.5, -0.3, 0.2, 0.3}}));
  EXPECT_FALSE(answer(SetThrusters{std::vector<double>(8, -1)}));
  EXPECT_FALSE(answer(to(20, 5, 30, 0.5)));
  EXPECT_FALSE(answer(to(20, 5, 30), {auv}));
  EXPECT_FALSE(answer(to(20, 5, 0), {usv}));
  EXPECT_FALSE(answer(to(20, 5, -40), {uav}));
  EXPECT_FALSE(answer(Reroute{}));
  EXPECT_FALSE(answer(HoldHere{}));
  EXPECT_FALSE(answer(GoHome{}));
  EXPECT_FALSE(answer(Resume{}));
}

TEST(Refusal, OfNumbersThatAreNone) {
  for (const double bad : {nan, inf, -inf}) {
    expect_no(answer(SetVelocity{{bad, 0, 0, 0}}), RefusalReason::not_finite, {"surge", "finite"});
    expect_no(answer(SetVelocity{{0, 0, 0, bad}}), RefusalReason::not_finite, {"yaw rate"});
    std::vector<double> share(8, 0);
    share[3] = bad;
    expect_no(answer(SetThrusters{share}), RefusalReason::not_finite, {"thruster 4"});
    expect_no(answer(to(0, bad, 10)), RefusalReason::not_finite, {"waypoint 1"});
    expect_no(answer(to(0, 0, 10, bad)), RefusalReason::not_finite, {"waypoint 1"});
  }
}

TEST(Refusal, OfThrustersBeyondOneOrOfAnotherNumber) {
  std::vector<double> share(8, 0);
  share[7] = -1.01;
  expect_no(answer(SetThrusters{share}), RefusalReason::out_of_range,
            {"thruster 8", "-1.01", "-1 to 1"});
  expect_no(answer(SetThrusters{{0.1, 0.2}}), RefusalReason::wrong_count,
            {"found 2", "expected 8", "order"});
}

TEST(Refusal, OfActuatorsThatTheVehicleHasNotOrBeyondTheirRange) {
  const auto one = [](std::size_t channel, double value, bool is_physical = false) {
    SetActuators set{{}, is_physical};
    set.given.give(channel, value);
    return set;
  };
  EXPECT_FALSE(answer(one(rudder_channel, -1), {auv}));
  EXPECT_FALSE(
      answer(one(rudder_channel, fleet().agents[auv].vehicle->rudder.limit_rad, true), {auv}));
  expect_no(answer(SetActuators{}, {usv}), RefusalReason::wrong_count,
            {"found none", "a WAM-V 16 has thruster_1, thruster_2"});
  expect_no(answer(one(rudder_channel, 0.1), {usv}), RefusalReason::out_of_range,
            {"found channel 9", "a WAM-V 16 has thruster_1, thruster_2"});
  expect_no(answer(one(rudder_channel, 1.01), {auv}), RefusalReason::out_of_range,
            {"rudder: found 1.01", "-1 to 1 of its range"});
  expect_no(answer(one(rudder_channel, 2, true), {auv}), RefusalReason::out_of_range,
            {"rudder: found 2", "rad"});
  expect_no(answer(one(volume_channel, nan), {auv}), RefusalReason::not_finite, {"volume"});
  expect_no(answer(one(rudder_channel, 0.1), {auv, {}, {}, 12}), RefusalReason::stale,
            {"actuators"});
}

TEST(Refusal, OfSpeedsBeyondTheVehiclesOwn) {
  expect_no(answer(SetVelocity{{5, 0, 0, 0}}), RefusalReason::out_of_range, {"surge", "found 5"});
  expect_no(answer(SetVelocity{{0, -5, 0, 0}}), RefusalReason::out_of_range, {"sway"});
  expect_no(answer(SetVelocity{{0, 0, 9, 0}}), RefusalReason::out_of_range, {"heave"});
  expect_no(answer(SetVelocity{{0, 0, 0, 99}}), RefusalReason::out_of_range, {"yaw rate"});
  const double most = fleet().agents[rov].autopilot->settings.most_speed_m_s;
  EXPECT_FALSE(answer(SetVelocity{{most, 0, 0, 0}}));
  expect_no(answer(SetVelocity{{0.9 * most, 0.9 * most, 0, 0}}), RefusalReason::out_of_range,
            {"surge and sway"});
  // What a kind cannot do at all.
  expect_no(answer(SetVelocity{{-0.1, 0, 0, 0}}, {auv}), RefusalReason::out_of_range, {"surge"});
  expect_no(answer(SetVelocity{{0.5, 0.1, 0, 0}}, {auv}), RefusalReason::out_of_range, {"sway"});
  expect_no(answer(SetVelocity{{0.5, 0.1, 0, 0}}, {usv}), RefusalReason::out_of_range, {"sway"});
  expect_no(answer(SetVelocity{{0.5, 0, 0.1, 0}}, {usv}), RefusalReason::out_of_range, {"heave"});
  expect_no(answer(to(20, 5, 30, 9)), RefusalReason::out_of_range, {"waypoint 1", "found 9"});
  expect_no(answer(to(20, 5, 30, -1)), RefusalReason::out_of_range, {"waypoint 1"});
  expect_no(answer(to(20, 5, 30, 0.01), {auv}), RefusalReason::out_of_range, {"waypoint 1"});
}

TEST(Refusal, OfPlacesWhereTheVehicleCannotBe) {
  expect_no(answer(to(0, 0, 61)), RefusalReason::no_place, {"61.0 m deep", "below_bed"});
  expect_no(answer(to(0, 0, -0.5)), RefusalReason::no_place, {"above the sea", "swims"});
  expect_no(answer(to(0, 0, 1), {uav}), RefusalReason::no_place, {"below the sea", "flies"});
  expect_no(answer(to(102, 1, 30)), RefusalReason::no_place, {"structure 1", "move it out"});
  expect_no(answer(to(102, 1, 30), {usv}), RefusalReason::no_place, {"structure 1"});
  expect_no(answer(to(9e5, 0, 10)), RefusalReason::no_place, {"outside"});
  // The one that is meant is named.
  Reroute list{{{{0, 0, 10}, 0}, {{0, 5, 10}, 0}, {{0, 0, 99}, 0}}};
  expect_no(answer(list), RefusalReason::no_place, {"waypoint 3"});
  // A surface craft has no depth to give.
  EXPECT_FALSE(answer(to(0, 0, 3), {usv}));
}

TEST(Refusal, OfAWayThroughAStructure) {
  const Reroute through{{{{80, 0, 30}, 0}, {{120, 0, 30}, 0}}};
  expect_no(answer(through), RefusalReason::no_place, {"waypoint 2", "through structure 1"});
  // Back to the first one, too.
  Reroute round{{{{80, 0, 30}, 0}, {{80, 20, 30}, 0}, {{120, 20, 30}, 0}, {{120, 0, 30}, 0}}};
  EXPECT_FALSE(answer(round));
  round.loop = true;
  expect_no(answer(round), RefusalReason::no_place, {"waypoint 1", "through structure 1"});
}

TEST(Refusal, BelowItsRatedDepth) {
  const auto& rated = fleet().agents[rov].vehicle->rated_depth_m;
  ASSERT_TRUE(rated);
  expect_no(answer(to(0, 0, *rated + 1)), RefusalReason::no_place, {"rated"});
}

TEST(Refusal, OfTooManyWaypoints) {
  expect_no(answer(Reroute{std::vector<Waypoint>(10001, {{0, 0, 10}, 0})}), RefusalReason::too_many,
            {"found 10001", "at most 10000"});
}

TEST(Refusal, OfWhatIsStale) {
  for (const std::uint64_t last : {5U, 6U})
    expect_no(answer(SetVelocity{}, {rov, {}, last}), RefusalReason::stale,
              {"found sequence 5", "count upwards"});
  EXPECT_FALSE(answer(SetVelocity{}, {rov, {}, 4}));
  // Received at 10 s.
  EXPECT_FALSE(answer(SetVelocity{}, {rov, {}, {}, 11}));
  expect_no(answer(SetVelocity{}, {rov, {}, {}, 11.1}), RefusalReason::stale,
            {"came in at 10 s", "it is 11.1 s"});
  expect_no(answer(SetThrusters{std::vector<double>(8, 0)}, {rov, {}, {}, 12}),
            RefusalReason::stale, {"send a new one"});
  expect_no(answer(SetVelocity{}, {rov, {}, {}, 8}), RefusalReason::stale, {});
  EXPECT_FALSE(answer(to(0, 0, 10), {rov, {}, {}, 100})) << "a list does not age";
}

TEST(Refusal, OfVehiclesThatAreNotFree) {
  Standing halted;
  halted.halt = Halt::aground;
  halted.halted_at_s = 7;
  expect_no(answer(HoldHere{}, {rov, halted}), RefusalReason::vehicle_halted,
            {"rov", "aground", "7 s"});
  Standing aboard;
  aboard.is_aboard = true;
  expect_no(answer(HoldHere{}, {rov, aboard}), RefusalReason::vehicle_not_free, {"aboard"});
  Standing needed;
  needed.must_come_home = true;
  needed.energy_left_j = 1000;
  needed.energy_home_j = 900;
  expect_no(answer(SetVelocity{}, {rov, needed}), RefusalReason::vehicle_not_free,
            {"reserve", "1000 J", "900"});
  EXPECT_FALSE(answer(GoHome{}, {rov, needed}));
  EXPECT_FALSE(answer(Resume{}, {rov, needed}));
}

TEST(Refusal, EachReasonHasAName) {
  for (int i = 0; i <= static_cast<int>(RefusalReason::unreadable); ++i)
    EXPECT_STRNE(name_of(static_cast<RefusalReason>(i)), "unknown");
}

}  // namespace
}  // namespace slackwater::twin::refusal_test
