// A person at the far end of a bad link: 30 % of the packets lost, 200 ms there and back. Nothing
// that came late is carried out, and the seat, the helm and the picture come through.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/api/door/people/station_for_tests.h"
#include "tests/support/lossy_link.h"
#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests::lossy_session_test {
namespace {

using namespace std::chrono_literals;
using nlohmann::json;
using people::Role;
using End = LossyLink::End;

const std::string rov = calm_head(0.05) +
                        "  - {name: rov, model: bluerov2_heavy, start: {north_m: 0, east_m: 0, "
                        "depth_m: 10}, tasks: [{do: hold}]}\n";

struct SentStick {
  std::int64_t id = 0, until = 0;
};

/// When a step began, on the clock of the session: by the frames, which are sent after it.
std::int64_t clock_of_step(const StationClient& station, std::uint64_t step) {
  std::int64_t clock = std::numeric_limits<std::int64_t>::max();
  for (const std::string& bytes : station.frames) {
    const auto* frame = session::GetFrame(bytes.data());
    if (frame->step() >= step)
      clock = std::min(clock, static_cast<std::int64_t>(frame->clock_ms()));
  }
  return clock;
}

TEST(LossySession, NothingRunsLateAndTheSeatComesThrough) {
  if (std::getenv("SLACKWATER_LOSSY_LINK") == nullptr)
    GTEST_SKIP() << "a minute over a bad link: SLACKWATER_LOSSY_LINK=1 (make soak)";
  std::unique_ptr<LossyLink> link;
  try {
    link = std::make_unique<LossyLink>(100ms);
  } catch (const std::runtime_error& e) {
    GTEST_SKIP() << e.what();
  }
  SessionUnderWay::Choice choice;
  choice.address = LossyLink::address(End::near);
  choice.where = [&](const std::function<void()>& work) { link->at(End::near, work); };
  SessionUnderWay run(rov, std::move(choice));
  std::optional<StationClient> pilot;
  const ServerPlace place(run.port(), LossyLink::address(End::near));
  link->at(End::far, [&] { pilot.emplace(place, run.token(Role::drives)); });
  ASSERT_TRUE(pilot->hello("Ann").is_object());
  ASSERT_EQ(pilot->asks({{"do", "ask"}, {"vehicle", 0}})["taken"], true);
  link->lose(0.3);
  std::vector<SentStick> sent;
  for (int i = 0; i < 400; ++i) {
    json stick = pilot->command("stick", 0, {{"velocity", {0.2, 0, 0, 0}}});
    stick["until"] = stick["at"].get<std::int64_t>() + 400;
    sent.push_back({pilot->says(stick), stick["until"]});
    pilot->listen(50ms);
  }
  const double lost_share =
      static_cast<double>(link->lost()) / static_cast<double>(link->lost() + link->carried());
  link->lose(0);
  pilot->listen(5s);
  EXPECT_GT(lost_share, 0.2) << "the link was too good";
  int taken = 0, stale = 0;
  for (const json& answer : pilot->messages) {
    if (answer["is"] != "answer") continue;
    const auto stick = std::find_if(sent.begin(), sent.end(),
                                    [&](const SentStick& one) { return one.id == answer["id"]; });
    if (stick == sent.end()) continue;
    if (answer["taken"] == false) {
      ++stale;
      EXPECT_EQ(answer["reason"], "stale") << answer;
      continue;
    }
    ++taken;
    // It takes effect with the next step after it came, 50 ms long, and that is told 50 ms later;
    // 150 ms more for a machine with other things to do. Late would be a second and more.
    EXPECT_LT(clock_of_step(*pilot, answer["step"]) - 250, stick->until);
  }
  std::printf("%d sticks taken, %d too late, %d not answered; %.0f %% of the packets lost\n", taken,
              stale, 400 - taken - stale, 100 * lost_share);
  EXPECT_GT(taken, 20);
  EXPECT_GT(stale, 20) << "the link was too good to prove anything";
  // The picture is of now again, and the helm is the seat's still, or told to be lost and back.
  const std::size_t frames = pilot->frames.size();
  pilot->listen(1s);
  EXPECT_GT(pilot->frames.size(), frames + 2) << "a vehicle at rest is told a few times a second";
  EXPECT_LT(pilot->clock() - static_cast<std::int64_t>(
                                 session::GetFrame(pilot->frames.back().data())->clock_ms()),
            400);
  EXPECT_EQ(pilot->asks(pilot->command("stick", 0, {{"velocity", {0.1, 0, 0, 0}}}))["taken"], true);
}

}  // namespace
}  // namespace slackwater::tests::lossy_session_test
