// The same commands, by a person and by a client of DDS: the same track, to the last bit.
#include <gtest/gtest.h>

#include "api/door/live/command_door.h"
#include "api/door/people/run_desk.h"
#include "tests/support/vehicle_for_tests.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::same_track_test {
namespace {

using nlohmann::json;

constexpr double step_s = 0.05;
constexpr int steps = 400;

const std::string rov = calm_head(step_s) +
                        "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                        "depth_m: 10}, tasks: [{do: hold}]}\n";

/// What the stick asks for before a step.
twin::HelmVelocity asked_at(int step) {
  return {0.3 * std::sin(0.02 * step), 0.1, step > 200 ? 0.05 : 0, 0.2 * std::cos(0.01 * step)};
}

using Pilot = std::function<void(int step)>;
/// @param begin  makes the pilot of a run
std::vector<twin::Triple<double>> track_of(
    const std::function<Pilot(const api::RunInHand&)>& begin) {
  const twin::Scenario scenario = twin::parse_scenario(rov, "test.yaml");
  std::vector<twin::Triple<double>> track;
  api::RunChoice choice;
  choice.on_ready = [&](const api::RunInHand& hand) {
    const Pilot pilot = begin(hand);
    for (int i = 0; i < steps; ++i) {
      pilot(i);
      hand.run.step();
      track.push_back(hand.run.seen(0).position_m);
    }
    hand.control.stop();
  };
  (void)api::run_scenario(scenario, api::water_of(scenario, {}, {}), choice);
  return track;
}

Pilot person(const api::RunInHand& hand) {
  const people::TokenBook book = people::TokenBook::drawn(UtcTime::max());
  const auto seats = std::make_shared<people::Seats>(book);
  (void)seats->take(book.grants()[1].token, "pilot", {});
  const auto desk = std::make_shared<people::RunDesk>(hand);
  const auto look = std::make_shared<people::RunLook>(hand);
  return [=](int step) {
    const std::int64_t clock = 50 * step;
    const people::RunNow now = look->look();
    const auto says = [&](const json& message) {
      const people::Said said =
          desk->handle({*seats->find(1), people::StationSays(message.dump()), *seats, now, clock});
      EXPECT_FALSE(said.refused) << said.refused->text;
    };
    if (step == 0) says({{"do", "ask"}, {"vehicle", 0}});
    const twin::HelmVelocity v = asked_at(step);
    says({{"do", "stick"},
          {"vehicle", 0},
          {"number", step + 1},
          {"at", clock},
          {"until", clock + 400},
          {"velocity", {v.surge_m_s, v.sway_m_s, v.heave_m_s, v.yaw_rate_rad_s}}});
  };
}

Pilot client_of_dds(const api::RunInHand& hand) {
  const auto stream = std::make_shared<live::Stream>();
  const auto door = std::make_shared<live::CommandDoor>(
      *stream, hand.arbiter, live::RunPlace{hand.start, hand.origin, 0, step_s});
  door->open("rov", std::make_shared<const twin::Vehicle>(bundled_vehicle("bluerov2_heavy")));
  return [=](int step) {
    (void)stream;  // outlives the door
    const live::Submitted submitted = door->submit("dds 01", 0, twin::SetVelocity{asked_at(step)});
    EXPECT_FALSE(submitted.refusal) << *submitted.refusal;
  };
}

TEST(SameTrack, OfAPersonAndOfAClientOfDds) {
  const auto by_person = track_of(person), by_client = track_of(client_of_dds);
  ASSERT_EQ(by_person.size(), static_cast<std::size_t>(steps));
  for (int i = 0; i < steps; ++i) {
    ASSERT_EQ(by_person[i].x, by_client[i].x) << i;
    ASSERT_EQ(by_person[i].y, by_client[i].y) << i;
    ASSERT_EQ(by_person[i].z, by_client[i].z) << i;
  }
  EXPECT_GT(std::hypot(by_person.back().x, by_person.back().y), 0.5) << "it did go somewhere";
}

}  // namespace
}  // namespace slackwater::tests::same_track_test
