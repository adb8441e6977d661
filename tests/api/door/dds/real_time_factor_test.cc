// `slackwater live` on DDS, as slow and as fast as it may be asked to be: what a client hears of
// the clock, by its own clock on the wall.
#include <gtest/gtest.h>

#include <cstring>

#include "api/door/dds/participant.h"
#include "tests/api/door/dds/inbox.h"
#include "tests/api/door/dds/own_domain.h"
#include "tests/api/door/dds/without_leaks.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::real_time_factor_test {
namespace {

using namespace std::chrono_literals;

struct Tick {
  double run_s = 0;
  std::chrono::steady_clock::time_point at = {};
};

double wall_s(const Tick& from, const Tick& to) {
  return std::chrono::duration<double>(to.at - from.at).count();
}

/// So many ticks of a run at this factor, one each step, after the first two.
std::vector<Tick> ticks_at(const char* factor, std::size_t count) {
  const OwnDomain domain;
  const TemporaryFolder folder;
  Inbox<Tick> ticks;
  dds::DomainSettings settings;
  settings.domain = domain.number();
  settings.is_loopback_only = true;
  dds::Participant listener(settings);
  listener.subscribe({"/clock", "rosgraph_msgs/msg/Clock", "", {false, false, 10}},
                     [&](dds::Payload message, const std::string&) {
                       std::int32_t seconds = 0;
                       std::uint32_t nanoseconds = 0;
                       if (message.size() < 12) return;
                       std::memcpy(&seconds, message.data() + 4, 4);
                       std::memcpy(&nanoseconds, message.data() + 8, 4);
                       ticks.put({seconds + 1e-9 * nanoseconds, std::chrono::steady_clock::now()});
                     });
  StartedProgram run(
      start_program({"live", live_scenario(), "--dds-domain", std::to_string(domain.number()),
                     "--loopback", "--real-time-factor", factor, "--record", folder / "run.mcap"},
                    without_leaks()));
  std::vector<Tick> heard = ticks.wait(count + 2, 60s);
  EXPECT_EQ(run.end(SIGINT), 0);
  EXPECT_GE(expect_even_clock(messages_of(folder / "run.mcap")), heard.size());
  if (heard.size() < count + 2) {
    ADD_FAILURE() << "heard " << heard.size() << " ticks at " << factor;
    return {};
  }
  return {heard.begin() + 2, heard.begin() + 2 + static_cast<std::ptrdiff_t>(count)};
}

// A step of 0.05 s takes half a second: eight intervals of them, each by itself too.
TEST(RealTimeFactor, OfATenthLetsAStepTakeTenTimesAsLong) {
  const std::vector<Tick> ticks = ticks_at("0.1", 9);
  ASSERT_FALSE(ticks.empty());
  EXPECT_NEAR(ticks.back().run_s - ticks.front().run_s, 8 * 0.05, 1e-6) << "one was not heard";
  // What holds one of the two ends up on a busy machine, s.
  constexpr double held_up_s = 0.4;
  EXPECT_NEAR(wall_s(ticks.front(), ticks.back()), 4, held_up_s);
  for (std::size_t i = 1; i < ticks.size(); ++i)
    EXPECT_NEAR(wall_s(ticks[i - 1], ticks[i]), 0.5, held_up_s) << i;
}

// Nothing is waited for. Sanitized on a busy machine it is still several times as fast as the wall.
TEST(RealTimeFactor, OfNoneGoesAsFastAsTheMachineCan) {
  const std::vector<Tick> ticks = ticks_at("0", 200);
  ASSERT_FALSE(ticks.empty());
  for (std::size_t i = 1; i < ticks.size(); ++i) EXPECT_GT(ticks[i].run_s, ticks[i - 1].run_s) << i;
  const double factor =
      (ticks.back().run_s - ticks.front().run_s) / wall_s(ticks.front(), ticks.back());
  EXPECT_GT(factor, 3);
  RecordProperty("factor", std::to_string(factor));
}

}  // namespace
}  // namespace slackwater::tests::real_time_factor_test
