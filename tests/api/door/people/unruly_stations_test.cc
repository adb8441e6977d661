// Stations that say anything in any order: no answer but a clear one, and never two at a helm.
#include <gtest/gtest.h>

#include "api/door/people/run_desk.h"
#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/support/asked_number.h"
#include "tests/twin/run/helm_for_tests.h"

namespace slackwater::tests::unruly_stations_test {
namespace {

using nlohmann::json;
using people::Role;

json number_of(Rng& rng) {
  switch (static_cast<int>(9 * rng.uniform())) {
    case 0:
      return nullptr;
    case 1:
      return "7";
    case 2:
      return -1;
    case 3:
      return 1e308;
    case 4:
      return json::array({1, 2});
    case 5:
      return std::floor(3 * rng.uniform());
    default:
      return std::floor(1000 * rng.uniform());
  }
}

json message_of(Rng& rng, std::int64_t number, std::int64_t now) {
  static const std::vector<std::string> words{
      "ask",   "give_back", "allow", "grant", "deny",   "take_back", "raw",
      "stick", "thrusters", "hold",  "home",  "pause",  "waypoints", "resume",
      "go_on", "step",      "spawn", "fly",   "camera", "weather"};
  const auto pick = [&](std::size_t of) {
    return static_cast<std::size_t>(static_cast<double>(of) * rng.uniform());
  };
  json message{{"do", words[pick(words.size())]},
               {"vehicle", 0},
               {"number", number},
               {"at", now},
               {"until", now + 300},
               {"velocity", {0.1, 0, 0, 0}},
               {"share", {0, 0, 0, 0, 0, 0, 0, 0}},
               {"places", {{{"east_m", 5}, {"north_m", 1}, {"up_m", -20}, {"speed_m_s", 0}}}},
               {"reason", "so"},
               {"is_on", true},
               {"steps", 1},
               {"model", "nothing"},
               {"name", "late"},
               {"east_m", 1},
               {"north_m", 1},
               {"up_m", -5},
               {"heading_deg", 0},
               {"pan_deg", 20},
               {"tilt_deg", 0},
               {"zoom", 2},
               {"wind", {{"speed_m_s", 5}, {"from_deg", 10}}},
               {"current", nullptr},
               {"visibility_m", 900},
               {"over_s", 5}};
  // One thing of it is wrong, in half of them.
  if (rng.uniform() < 0.5) {
    static const std::vector<std::string> keys{"vehicle", "number", "at",      "until", "velocity",
                                               "share",   "places", "steps",   "name",  "is_on",
                                               "zoom",    "wind",   "current", "over_s"};
    message[keys[pick(keys.size())]] = number_of(rng);
  }
  return message;
}

TEST(UnrulyStations, AreAnsweredAndNeverTwoAtOneHelm) {
  const int messages = std::max(5'000, asked_number("SLACKWATER_MUTATIONS", 0));
  const twin::Scenario scenario = twin::parse_scenario(
      lone("bluerov2_heavy", "north_m: 0, east_m: 0, depth_m: 20"), "test.yaml");
  api::ScenarioWater water = api::water_of(scenario, {}, {});
  api::RunChoice choice;
  choice.real_time_factor = 0;
  int taken = 0, refused = 0, unreadable = 0;
  choice.on_ready = [&](const api::RunInHand& hand) {
    people::Seats seats(people::TokenBook::drawn(UtcTime::max()));
    const people::TokenBook book = people::TokenBook::drawn(UtcTime::max());
    seats = people::Seats(book);
    for (const std::size_t grant : {1U, 1U, 0U, 2U})
      (void)seats.take(book.grants()[grant].token, "", {});
    people::RunDesk desk(hand);
    people::RunLook look(hand);
    people::RunNow now = look.look();
    Rng rng(3, "unruly");
    std::int64_t clock = 0;
    std::array<std::int64_t, 5> number{};
    for (int i = 0; i < messages; ++i) {
      const unsigned of = 1 + static_cast<unsigned>(4 * rng.uniform());
      const people::Seat seat = *seats.find(of);
      clock += static_cast<std::int64_t>(400 * rng.uniform());
      const json message = message_of(rng, ++number[of], clock);
      try {
        const people::StationSays says(message.dump());
        const people::Said said = desk.handle({seat, says, seats, now, clock});
        if (said.refused) {
          ++refused;
          ASSERT_FALSE(said.refused->text.empty()) << message;
        } else {
          ++taken;
          ASSERT_NE(seat.role, Role::looks_on) << message;
        }
      } catch (const Error& e) {
        ++unreadable;
        ASSERT_EQ(e.kind(), ErrorKind::invalid_input) << message;
      }
      if (i % 7 == 0) {
        hand.run.step();
        now = look.look();
      }
      (void)desk.helms().look(seats, clock);
      const people::HelmNow& helm = desk.helms().now(0);
      const std::string holder = hand.arbiter.holder(0);
      ASSERT_EQ(holder, helm.seat == 0 ? helm.agent : client_of(*seats.find(helm.seat)))
          << i << " " << message;
    }
    hand.control.resume();
    hand.control.stop();
  };
  (void)api::run_scenario(scenario, water, choice);
  EXPECT_GT(taken, messages / 20);
  EXPECT_GT(refused, messages / 20);
  EXPECT_GT(unreadable, messages / 30);
}

}  // namespace
}  // namespace slackwater::tests::unruly_stations_test
