// A person's stick in a run as it is: water that moves, a vehicle that lags behind what is asked.
#include <gtest/gtest.h>

#include <cmath>

#include "api/door/people/run_desk.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::stick_in_water_test {
namespace {

using nlohmann::json;

constexpr double step_s = 0.05;
constexpr double stand_off_m = 0.8;

/// An ROV north of a pile of 8 m, in a current that sets south on it.
std::string rov_before_a_pile(double current_m_s) {
  return "name: test\nseed: 7\nduration: 30min\nstep_s: 0.05\nlog_every_s: 1\n"
         "water: {made_up: {depth_m: 40, current: [{depth_m: 0, east_m_s: 0, north_m_s: " +
         std::to_string(-current_m_s) +
         "}]}}\n"
         "structures:\n  - {kind: cylinder, north_m: 0, east_m: 0, diameter_m: 8, top_height_m: "
         "10, bottom_depth_m: 40}\n"
         "vehicles:\n  - name: rov\n    model: bluerov2_heavy\n"
         "    start: {north_m: 12, east_m: 0, depth_m: 15, heading_deg: 180}\n"
         "    tasks: [{do: hold}]\n"
         "    conduct: {autonomy: shared, envelope: {most_speed_m_s: 0.5, stand_off_m: 0.8, "
         "fence_m: 120}}\n";
}

/// The stick is held for a minute, twenty commands a second. @return the least distance
double nearest_m(double current_m_s, double surge_m_s) {
  const twin::Scenario scenario = twin::parse_scenario(rov_before_a_pile(current_m_s), "test.yaml");
  double nearest = 1e9;
  api::RunChoice choice;
  choice.on_ready = [&](const api::RunInHand& hand) {
    const people::TokenBook book = people::TokenBook::drawn(UtcTime::max());
    people::Seats seats(book);
    (void)seats.take(book.grants()[1].token, "pilot", {});
    people::RunDesk desk(hand);
    people::RunLook look(hand);
    people::RunNow now = look.look();
    std::int64_t clock = 0;
    const auto says = [&](const json& message) {
      const people::Said said =
          desk.handle({*seats.find(1), people::StationSays(message.dump()), seats, now, clock});
      EXPECT_FALSE(said.refused) << said.refused->text;
      return said;
    };
    (void)says({{"do", "ask"}, {"vehicle", 0}});
    for (int i = 1; i <= 60 / step_s; ++i) {
      const people::Said said = says({{"do", "stick"},
                                      {"vehicle", 0},
                                      {"number", i},
                                      {"at", clock},
                                      {"until", clock + 400},
                                      {"velocity", {surge_m_s, 0, 0, 0}}});
      hand.run.step();
      clock += 50;
      now = look.look();
      const people::Pose& pose = now.vehicles[0].pose;
      nearest = std::min(nearest, std::hypot(double{pose.north_m}, double{pose.east_m}) - 4.0);
    }
    hand.control.stop();
  };
  (void)api::run_scenario(scenario, api::water_of(scenario, {}, {}), choice);
  return nearest;
}

// The vehicle follows what is asked with a lag of some tenths of a second: at the 0.5 m/s of its
// envelope, slowed down as it comes near, that is a few centimetres.
TEST(StickInWater, KeepsOffAPileInStillWaterAndInACurrentThatSetsOnIt) {
  for (const double current_m_s : {0.0, 0.2, 0.4}) {
    const double nearest = nearest_m(current_m_s, 0.5);
    EXPECT_GT(nearest, stand_off_m - 0.1) << current_m_s;
    EXPECT_LT(nearest, stand_off_m + 0.2) << "it does come near: " << current_m_s;
  }
}

TEST(StickInWater, HoldsOffAPileWhereNothingIsAskedOfIt) {
  EXPECT_GT(nearest_m(0.4, 0.0), stand_off_m - 0.1);
}

}  // namespace
}  // namespace slackwater::tests::stick_in_water_test
