#include "data/bag/recording.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "tests/data/bag/samples.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bag::tests::recording_test {
namespace {

using slackwater::tests::error_of;
using slackwater::tests::TemporaryFolder;

/// Both kinds of recording, by the name that makes them.
class Recording : public testing::TestWithParam<const char*> {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return folder_ / GetParam(); }
  TemporaryFolder folder_;
};
INSTANTIATE_TEST_SUITE_P(OfEachKind, Recording, testing::Values("run", "run.mcap"),
                         [](const auto& kind) {
                           return std::string(kind.param) == "run" ? "Rosbag" : "Mcap";
                         });

TEST_P(Recording, GivesBackChannelsTimesAndBytes) {
  const auto messages = some_messages();
  {
    Writer writer = open_recording(path());
    for (const Message& message : messages) write(writer, message);
    EXPECT_EQ(writer.messages(), messages.size());
    writer.close();
  }
  const auto bag = open_bag(path());
  EXPECT_TRUE(bag->warnings().empty());
  EXPECT_EQ(bag->channels(), (std::vector<Channel>{level_channel(), wind_channel()}));
  EXPECT_EQ(all_of(*bag), messages);
}

TEST_P(Recording, MessagesOutOfOrderAreReadInTheOrderOfTime) {
  // Among them two of one time, which keep the order in which they came, and leaps over batches.
  std::vector<Message> messages;
  for (const std::int64_t second : {5, 3, 9, 3, 0, 12, 7, 7, 1, 30, 2})
    messages.push_back({level_channel(), second * 1'000'000'000,
                        level_payload(static_cast<double>(messages.size()))});
  {
    Writer writer = open_recording(path());
    for (const Message& message : messages) write(writer, message);
  }
  std::stable_sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) {
    return a.log_time_ns < b.log_time_ns;
  });
  EXPECT_EQ(all_in(path()), messages);
}

TEST_P(Recording, ChannelsMayComeLateAndWithoutMessages) {
  Writer writer = open_recording(path());
  write(writer, {level_channel(), 0, level_payload(1)});
  writer.flush();
  static_cast<void>(writer.add_channel(wind_channel()));
  write(writer, {level_channel(), 1, level_payload(2)});
  writer.close();
  const auto bag = open_bag(path());
  EXPECT_EQ(bag->channels(), (std::vector<Channel>{level_channel(), wind_channel()}));
  EXPECT_EQ(all_of(*bag).size(), 2U);
}

TEST_P(Recording, WithoutAnythingInItOpens) {
  open_recording(path()).close();
  const auto bag = open_bag(path());
  EXPECT_TRUE(bag->channels().empty());
  EXPECT_TRUE(bag->warnings().empty());
  EXPECT_FALSE(bag->next());
}

TEST_P(Recording, LargeMessagesAndManyBatchesComeBack) {
  std::vector<Message> messages;
  for (std::size_t i = 0; i < 40; ++i)
    messages.push_back({wind_channel(), static_cast<std::int64_t>(i), noise_payload(i, 300'000)});
  messages.push_back({wind_channel(), 100, noise_payload(99, 9'000'000)});
  {
    Writer writer = open_recording(path());
    for (const Message& message : messages) write(writer, message);
  }
  EXPECT_TRUE(all_in(path()) == messages);
}

TEST_P(Recording, ReachesTheDiskWithinASecondAndAtAFlush) {
  std::chrono::steady_clock::time_point now{};
  Writer writer = open_recording(path(), [&] { return now; });
  const auto at = [&](int milliseconds) {
    now = std::chrono::steady_clock::time_point(std::chrono::milliseconds(milliseconds));
    write(writer, {level_channel(), 0, level_payload(milliseconds)});
    return all_in(path()).size();
  };
  EXPECT_EQ(at(5000), 0U);
  EXPECT_EQ(at(5999), 0U);
  EXPECT_EQ(at(6000), 3U);
  EXPECT_EQ(at(6001), 3U);
  EXPECT_EQ(at(7000), 3U) << "the batch began at 6001";
  writer.flush();
  EXPECT_EQ(all_in(path()).size(), 5U);
}

TEST_P(Recording, NeverWritesOverWhatIsThere) {
  open_recording(path()).close();
  try {
    static_cast<void>(open_recording(path()));
    FAIL() << "wrote over a recording";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
    EXPECT_NE(error.message().find(path().string()), std::string::npos) << error.message();
    EXPECT_NE(error.message().find("another name"), std::string::npos) << error.message();
  }
  EXPECT_TRUE(all_in(path()).empty());
}

TEST_P(Recording, WithoutAFolderForItIsUnavailable) {
  try {
    static_cast<void>(open_recording(folder_ / "nowhere" / GetParam()));
    FAIL() << "made a folder";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::unavailable);
    EXPECT_NE(error.message().find("No such file"), std::string::npos) << error.message();
  }
}

TEST_P(Recording, ATopicHasOneType) {
  Writer writer = open_recording(path());
  const ChannelId id = writer.add_channel(level_channel());
  EXPECT_EQ(writer.add_channel(level_channel()), id);
  Channel other = wind_channel();
  other.topic = level_channel().topic;
  EXPECT_NE(error_of([&] { return writer.add_channel(other); }).find("another name"),
            std::string::npos);
  EXPECT_NE(writer.add_channel(wind_channel()), id);
}

TEST_P(Recording, IsNotUsedWrongly) {
  Writer writer = open_recording(path());
  const ChannelId id = writer.add_channel(level_channel());
  const auto payload = level_payload(0);
  EXPECT_THROW(writer.write(ChannelId(7), 0, payload), ContractViolation);
  EXPECT_THROW(writer.write(id, -1, payload), ContractViolation);
  EXPECT_THROW(writer.write(id, 0, Payload(payload).first(3)), ContractViolation);
  writer.close();
  writer.close();
  EXPECT_THROW(writer.write(id, 0, payload), ContractViolation);
}

TEST(OpenBag, SaysWhatIsNoRecording) {
  const TemporaryFolder folder;
  const auto said = [&](const std::string& name) {
    return error_of([&] { return open_bag(folder / name); });
  };
  EXPECT_NE(said("nothing").find("no recording"), std::string::npos);
  std::filesystem::create_directory(folder / "empty");
  EXPECT_NE(said("empty").find("neither metadata.yaml nor"), std::string::npos);
  std::ofstream(folder / "text.mcap") << "some text";
  EXPECT_NE(said("text.mcap").find("neither an MCAP file nor"), std::string::npos);
  std::ofstream(folder / "nil.db3");
  EXPECT_NE(said("nil.db3").find("neither an MCAP file nor"), std::string::npos);
  std::ofstream(folder / "packed.db3.zstd") << "\x28\xb5\x2f\xfd packed";
  EXPECT_NE(said("packed.db3.zstd").find("zstd -d"), std::string::npos);
}

}  // namespace
}  // namespace slackwater::bag::tests::recording_test
