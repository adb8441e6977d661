// A run that is recorded, and goes on where that cannot be.
#include "api/door/live/topics/recording_outlet.h"

#include <gtest/gtest.h>
#include <sys/resource.h>

#include <csignal>

#include "data/bag/bag.h"
#include "fields/base/error.h"
#include "tests/support/comes_true.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::tests::recording_outlet_test {
namespace {

const bag::Channel level{"/site/tide_level", "std_msgs/msg/Float64", "float64 data\n", {}};

dds::Bytes message_of(std::uint8_t value, std::size_t size = 12) {
  dds::Bytes bytes(size, value);
  std::copy_n(std::begin({std::uint8_t{0}, std::uint8_t{1}, std::uint8_t{0}, std::uint8_t{0}}), 4,
              bytes.begin());
  return bytes;
}

std::size_t messages_in(const std::filesystem::path& path) {
  const auto recording = bag::open_bag(path);
  std::size_t count = 0;
  while (recording->next()) ++count;
  return count;
}

TEST(RecordingOutlet, HasAllThatWasSaid) {
  const TemporaryFolder folder;
  for (const char* name : {"run.mcap", "run"}) {
    live::RecordingOutlet outlet(folder / name, [](const std::string& text) { FAIL() << text; });
    outlet.open(level, live::Direction::told);
    for (std::uint8_t i = 0; i < 200; ++i) outlet.publish(0, {i, 0}, message_of(i));
    EXPECT_EQ(outlet.close(), 200U);
    EXPECT_EQ(messages_in(folder / name), 200U) << name;
  }
}

TEST(RecordingOutlet, WhatWasSaidBeforeAPauseIsReadableWhileItLasts) {
  const TemporaryFolder folder;
  for (const char* name : {"run.mcap", "run"}) {
    live::RecordingOutlet outlet(folder / name, [](const std::string& text) { FAIL() << text; });
    outlet.open(level, live::Direction::told);
    for (std::uint8_t i = 0; i < 10; ++i) outlet.publish(0, {i, 0}, message_of(i));
    EXPECT_TRUE(comes_true([&] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      return messages_in(folder / name) == 10;
    })) << name;
  }
}

/// As `ros2 bag record -a` does: readers of bags know no type of an action's topics.
TEST(RecordingOutlet, LeavesHiddenTopicsOut) {
  const TemporaryFolder folder;
  const bag::Channel feedback{
      "/rov/navigate/_action/feedback", "slackwater_msgs/action/Navigate_FeedbackMessage", "", {}};
  for (const char* name : {"run.mcap", "run"}) {
    live::RecordingOutlet outlet(folder / name, [](const std::string& text) { FAIL() << text; });
    outlet.open(feedback, live::Direction::told);
    outlet.open(level, live::Direction::told);
    EXPECT_FALSE(outlet.wants(0));
    EXPECT_TRUE(outlet.wants(1));
    outlet.publish(0, {1, 0}, message_of(1));
    outlet.publish(1, {2, 0}, message_of(2));
    EXPECT_EQ(outlet.close(), 1U);
    const auto recording = bag::open_bag(folder / name);
    ASSERT_EQ(recording->channels().size(), 1U) << name;
    EXPECT_EQ(recording->channels()[0].topic, level.topic);
  }
}

TEST(RecordingOutlet, WhereSomethingLiesNothingIsBegun) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "run");
  EXPECT_THROW(live::RecordingOutlet(folder / "run", {}), Error);
}

/// No file of this process grows beyond so much, as on a disk that is full.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    std::signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit most{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &most);
  }
  ~FullDisk() { setrlimit(RLIMIT_FSIZE, &before_); }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
};

TEST(RecordingOutlet, AFullDiskIsToldOnceAndWhatWasRecordedStaysReadable) {
  const TemporaryFolder folder;
  for (const char* name : {"run.mcap", "run"}) {
    std::vector<std::string> told;
    std::mutex mutex;
    std::size_t before = 0;
    {
      live::RecordingOutlet outlet(folder / name, [&](const std::string& text) {
        const std::lock_guard lock(mutex);
        told.push_back(text);
      });
      outlet.open(level, live::Direction::told);
      // Noise, which does not pack: beyond 12 MB there is no room.
      std::uint32_t noise = 1;
      const auto say = [&](int messages) {
        for (int i = 0; i < messages; ++i) {
          dds::Bytes message = message_of(0, 20'000);
          for (std::size_t k = 4; k < message.size(); ++k)
            message[k] = static_cast<std::uint8_t>((noise = noise * 1664525U + 1013904223U) >> 24U);
          outlet.publish(0, {i, 0}, message);
        }
      };
      const FullDisk disk(12'000'000);
      for (int i = 0; i < 100 && !outlet.has_failed(); ++i) {
        say(50);
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
      }
      ASSERT_TRUE(outlet.has_failed()) << name;
      EXPECT_FALSE(outlet.wants(0)) << "nobody makes messages for it any more";
      say(10);  // does not hurt
      before = static_cast<std::size_t>(outlet.close());
    }
    ASSERT_EQ(told.size(), 1U) << name;
    EXPECT_NE(told[0].find("goes on without it"), std::string::npos) << told[0];
    const std::size_t readable = messages_in(folder / name);
    EXPECT_GT(readable, 100U) << name << ": most of 12 MB";
    EXPECT_LE(readable, before) << name;
  }
}

}  // namespace
}  // namespace slackwater::tests::recording_outlet_test
