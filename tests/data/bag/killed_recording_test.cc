// A recorder that is killed, at any time, leaves what it had flushed.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "fields/base/numbers/random.h"
#include "tests/data/bag/samples.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bag::tests::killed_recording_test {
namespace {

using slackwater::tests::TemporaryFolder;

constexpr std::size_t payload_bytes = 3000;

Message numbered(std::size_t i) {
  return {i % 3 == 0 ? wind_channel() : level_channel(), static_cast<std::int64_t>(i) * 1'000'000,
          noise_payload(i, payload_bytes)};
}

/// Records until it is killed; after each flush it says how many messages were written.
[[noreturn]] void record(const std::filesystem::path& path, int pipe) {
  try {
    Writer writer = open_recording(path);
    for (std::size_t i = 0;; ++i) {
      write(writer, numbered(i));
      if (i % 50 != 49) continue;
      writer.flush();
      const std::size_t written = i + 1;
      if (::write(pipe, &written, sizeof written) < 0) _exit(3);
    }
  } catch (const std::exception&) {
    _exit(4);
  }
}

class KilledRecording : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(OfEachKind, KilledRecording, testing::Values("run", "run.mcap"),
                         [](const auto& kind) {
                           return std::string(kind.param) == "run" ? "Rosbag" : "Mcap";
                         });

TEST_P(KilledRecording, IsReadUpToItsLastFlush) {
  constexpr std::uint64_t seed = 1;
  Rng rng(seed, "kills of a recording");
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::size_t flushed_in_all = 0;
  for (int kill = 0; kill < 20; ++kill) {
    SCOPED_TRACE("kill " + std::to_string(kill));
    const TemporaryFolder folder;
    const auto path = folder / GetParam();
    int pipe[2];
    ASSERT_EQ(::pipe(pipe), 0);
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      ::close(pipe[0]);
      record(path, pipe[1]);
    }
    ::close(pipe[1]);
    std::size_t flushed = 0;
    ASSERT_EQ(::read(pipe[0], &flushed, sizeof flushed), ssize_t{sizeof flushed});
    ::usleep(static_cast<useconds_t>(rng.uniform(0, 60'000)));
    ASSERT_EQ(::kill(child, SIGKILL), 0);
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the recorder ended by itself";
    for (std::size_t more = 0; ::read(pipe[0], &more, sizeof more) == ssize_t{sizeof more};)
      flushed = more;
    ::close(pipe[0]);

    const auto bag = open_bag(path);
    const auto messages = all_of(*bag);
    EXPECT_GE(messages.size(), flushed);
    for (std::size_t i = 0; i < messages.size(); ++i) ASSERT_TRUE(messages[i] == numbered(i)) << i;
    const bool is_mcap = std::string(GetParam()) == "run.mcap";
    EXPECT_EQ(bag->warnings().size(), is_mcap ? 1U : 0U) << "no summary was written";
    flushed_in_all += flushed;
  }
  EXPECT_GT(flushed_in_all, 20U * 50U) << "the kills came before any work was done";
}

}  // namespace
}  // namespace slackwater::bag::tests::killed_recording_test
