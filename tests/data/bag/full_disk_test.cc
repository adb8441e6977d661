// The disk fills up while a recording is made.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>

#include "fields/base/error.h"
#include "tests/data/bag/samples.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bag::tests::full_disk_test {
namespace {

using slackwater::tests::TemporaryFolder;

Message numbered(std::size_t i) {
  return {i % 3 == 0 ? wind_channel() : level_channel(), static_cast<std::int64_t>(i),
          noise_payload(i, 2000)};
}

/// Writes until it is refused, flushing every fifty. What the refusal must be; returns how many
/// messages had been flushed.
std::size_t record_until_refused(const std::filesystem::path& path, const std::string& reason) {
  Writer writer = open_recording(path);
  const ChannelId level = writer.add_channel(level_channel());
  std::size_t flushed = 0;
  std::string said;
  for (std::size_t i = 0; said.empty() && i < 10'000; ++i) {
    try {
      write(writer, numbered(i));
      if (i % 50 != 49) continue;
      writer.flush();
      flushed = i + 1;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::unavailable);
      said = error.message();
    }
  }
  EXPECT_NE(said.find(path.filename()), std::string::npos) << said;
  EXPECT_NE(said.find(reason), std::string::npos) << said;
  EXPECT_NE(said.find("stays readable"), std::string::npos) << said;
  // From here on the same is said at once, and closing is quiet.
  const auto again = [&](const auto& call) {
    try {
      call();
      ADD_FAILURE() << "a failed recording is written";
    } catch (const Error& error) {
      EXPECT_EQ(error.message(), said);
    }
  };
  again([&] { writer.write(level, 0, level_payload(0)); });
  again([&] { writer.flush(); });
  again([&] { static_cast<void>(writer.add_channel({"/a", "a/msg/B", "", {}})); });
  EXPECT_NO_THROW(writer.close());
  return flushed;
}

void expect_all_flushed(const std::filesystem::path& path, std::size_t flushed) {
  EXPECT_GT(flushed, 100U);
  const auto messages = all_in(path);
  EXPECT_GE(messages.size(), flushed);
  for (std::size_t i = 0; i < messages.size(); ++i) ASSERT_TRUE(messages[i] == numbered(i)) << i;
}

class FullDisk : public testing::TestWithParam<const char*> {
 protected:
  ~FullDisk() override {
    if (is_mounted_) ::umount2(folder_.path().c_str(), MNT_DETACH);
  }
  /// Makes the folder a disk of that size; false where that is not permitted.
  bool mount(const char* size) {
    is_mounted_ = ::mount("tmpfs", folder_.path().c_str(), "tmpfs", 0, size) == 0;
    return is_mounted_;
  }

  TemporaryFolder folder_;
  bool is_mounted_ = false;
};
INSTANTIATE_TEST_SUITE_P(OfEachKind, FullDisk, testing::Values("run", "run.mcap"),
                         [](const auto& kind) {
                           return std::string(kind.param) == "run" ? "Rosbag" : "Mcap";
                         });

TEST_P(FullDisk, LeavesWhatWasFlushed) {
  if (!mount("size=3m")) GTEST_SKIP() << "cannot mount a tmpfs here: " << std::strerror(errno);
  const auto path = folder_ / GetParam();
  const std::size_t flushed = record_until_refused(path, "o space left");
  expect_all_flushed(path, flushed);
}

TEST_P(FullDisk, FromTheStartLeavesNothingBehind) {
  if (!mount("size=64k")) GTEST_SKIP() << "cannot mount a tmpfs here: " << std::strerror(errno);
  std::ofstream(folder_ / "filler") << std::string(200'000, 'f');
  const auto path = folder_ / GetParam();
  EXPECT_THROW(static_cast<void>(open_recording(path)), Error);
  EXPECT_FALSE(std::filesystem::exists(path));
}

TEST_P(FullDisk, AFileThatMayNotGrowIsRefusedAlike) {
  const auto path = folder_ / GetParam();
  // The limit is of the process: it is set in another.
  const pid_t child = ::fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    ::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1'500'000, 1'500'000};
    ::setrlimit(RLIMIT_FSIZE, &limit);
    const bool is_mcap = path.extension() == ".mcap";
    const std::size_t flushed =
        record_until_refused(path, is_mcap ? "File too large" : "disk I/O error");
    _exit(testing::Test::HasFailure() ? 100 : static_cast<int>(flushed / 50));
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status));
  ASSERT_LT(WEXITSTATUS(status), 100);
  expect_all_flushed(path, 50U * static_cast<std::size_t>(WEXITSTATUS(status)));
}

}  // namespace
}  // namespace slackwater::bag::tests::full_disk_test
