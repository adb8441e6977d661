// `slackwater live` is killed while it records.
#include <gtest/gtest.h>
#include <unistd.h>

#include "fields/base/numbers/random.h"
#include "tests/api/door/live/live_records.h"
#include "tests/support/asked_number.h"
#include "tests/support/comes_true.h"
#include "tests/support/started_program.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::killed_live_test {
namespace {

using namespace std::chrono_literals;

/// How many are readable of a file that grows, which is empty at first. The copy is cut short
/// somewhere, as a killed one is.
std::size_t readable(const std::filesystem::path& growing, const std::filesystem::path& copy) {
  std::error_code none;
  std::filesystem::copy_file(growing, copy, std::filesystem::copy_options::overwrite_existing,
                             none);
  return none || std::filesystem::file_size(copy) == 0 ? 0 : messages_of(copy).size();
}

/// What both have, and how far that goes, is the same.
void expect_one_run(std::vector<LiveMessage> a, std::vector<LiveMessage> b) {
  const std::size_t both = std::min(a.size(), b.size());
  for (std::size_t i = 0; i < both; ++i) ASSERT_EQ(a[i], b[i]) << "message " << i;
}

TEST(KilledLiveRun, LeavesRecordsThatReadToTheLastFlush) {
  // A twentieth of those of a soak: each takes some seconds.
  const int kills = std::max(2, asked_number("SLACKWATER_KILLS", 0) / 20);
  constexpr std::uint64_t seed = 1;
  Rng rng(seed, "kills of a live run");
  for (int kill = 0; kill < kills; ++kill) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", kill " + std::to_string(kill));
    const TemporaryFolder folder;
    const auto mcap = folder / "run.mcap", rosbag = folder / "run";
    StartedProgram run(start_program({"live", live_scenario(), "--real-time-factor", "10",
                                      "--record", mcap, "--record", rosbag}));
    // What one has, the other says that it has too: it has been flushed at least once.
    std::size_t early = 0;
    EXPECT_TRUE(
        comes_true([&] { return (early = readable(mcap, folder / "copy.mcap")) > 0; }, 60s));
    EXPECT_TRUE(comes_true([&] { return messages_told(rosbag) >= early; }, 60s));
    ::usleep(static_cast<useconds_t>(rng.uniform(0, 1'200'000)));
    ASSERT_EQ(run.end(SIGKILL), 128 + SIGKILL) << "it ended by itself";

    const auto in_mcap = messages_of(mcap), in_rosbag = messages_of(rosbag);
    EXPECT_GE(in_mcap.size(), early);
    EXPECT_GE(in_rosbag.size(), messages_told(rosbag));
    expect_one_run(in_mcap, in_rosbag);
    EXPECT_GT(expect_even_clock(in_mcap), 10U);
    EXPECT_GT(expect_even_clock(in_rosbag), 10U);
  }
}

}  // namespace
}  // namespace slackwater::tests::killed_live_test
