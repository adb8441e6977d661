#include "data/bag/mcap_bag.h"

#include <gtest/gtest.h>
#include <lz4frame.h>

#include <algorithm>

#include "fields/base/error.h"
#include "fields/base/numbers/random.h"
#include "tests/data/bag/made_up_mcap.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bag::tests::mcap_bag_test {
namespace {

using slackwater::tests::error_of;
using slackwater::tests::TemporaryFolder;

/// Our own, of several chunks.
Bytes small_recording(const std::vector<Message>& messages) {
  const TemporaryFolder folder;
  Writer writer = open_recording(folder / "a.mcap");
  for (std::size_t i = 0; i < messages.size(); ++i) {
    write(writer, messages[i]);
    if (i % 3 == 2) writer.flush();
  }
  writer.close();
  return bytes_of(folder / "a.mcap");
}

bool is_prefix(const std::vector<Message>& some, const std::vector<Message>& all) {
  return some.size() <= all.size() && std::equal(some.begin(), some.end(), all.begin());
}

TEST(McapBag, CutShortAtAnyByteIsReadUpToTheCut) {
  const auto messages = some_messages(5);
  const Bytes whole = small_recording(messages);
  const TemporaryFolder folder;
  std::size_t before = 0;
  std::size_t refused = 0;
  for (std::size_t length = 0; length < whole.size(); ++length) {
    SCOPED_TRACE(length);
    const auto file = write_file(folder / "cut.mcap", ByteView(whole).first(length));
    if (length < mcap_magic.size()) {
      EXPECT_THROW(all_in(file), Error);
      ++refused;
      continue;
    }
    const auto bag = open_bag(file);
    const auto found = all_of(*bag);
    EXPECT_TRUE(is_prefix(found, messages));
    // Once the data are whole the summary is not missed.
    EXPECT_TRUE(bag->warnings().size() == 1 || found.size() == messages.size());
    EXPECT_GE(found.size(), before) << "a longer piece holds less";
    before = found.size();
  }
  EXPECT_EQ(before, messages.size()) << "the last cut is in the summary";
  EXPECT_EQ(refused, mcap_magic.size());
}

TEST(McapBag, AnyByteChangedIsRefusedOrTold) {
  const auto messages = some_messages(5);
  const Bytes whole = small_recording(messages);
  const TemporaryFolder folder;
  std::size_t read_all = 0;
  std::size_t told = 0;
  for (std::size_t at = 0; at < whole.size(); ++at) {
    SCOPED_TRACE(at);
    Bytes damaged = whole;
    damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (at % 2 == 0 ? 0x01U : 0x80U));
    const auto file = write_file(folder / "damaged.mcap", damaged);
    try {
      const auto bag = open_bag(file);
      const auto found = all_of(*bag);
      // A name, a quality or a kind of record outside the chunks has no sum, and may come back
      // changed; but nothing is missing without a word.
      read_all += found.size() >= messages.size() ? 1 : 0;
      told += bag->warnings().empty() ? 0 : 1;
      EXPECT_TRUE(found.size() >= messages.size() || !bag->warnings().empty());
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << error.message();
      EXPECT_NE(error.message().find("damaged.mcap"), std::string::npos) << error.message();
      ++told;
    }
  }
  EXPECT_GT(told, whole.size() / 2);
  EXPECT_GT(read_all, 0U);
}

TEST(McapBag, ZerosAtTheEndAreTheEnd) {
  // As a power cut may leave them: the length reached the disk, and the bytes did not.
  const auto messages = some_messages(8);
  Bytes bytes = small_recording(messages);
  const TemporaryFolder folder;
  std::fill(bytes.begin() + static_cast<std::ptrdiff_t>(bytes.size() / 2), bytes.end(),
            std::uint8_t{0});
  const auto bag = open_bag(write_file(folder / "zeros.mcap", bytes));
  const auto found = all_of(*bag);
  EXPECT_TRUE(is_prefix(found, messages));
  EXPECT_FALSE(found.empty());
  EXPECT_LT(found.size(), messages.size());
  ASSERT_EQ(bag->warnings().size(), 1U);
  EXPECT_NE(bag->warnings()[0].find("cut short or damaged at byte"), std::string::npos);
}

TEST(McapBag, ChunksThatOverlapAreMergedInBoundedMemory) {
  // 40 chunks that all span the same minute: whatever is held, the answer is the same.
  Rng rng(1, "overlapping chunks");
  const TemporaryFolder folder;
  std::vector<Message> messages;
  {
    Writer writer = open_recording(folder / "a.mcap");
    for (std::size_t i = 0; i < 40; ++i) {
      for (std::size_t j = 0; j < 10; ++j) {
        messages.push_back({level_channel(), static_cast<std::int64_t>(rng.uniform(0, 50)),
                            noise_payload(messages.size(), 200)});
        write(writer, messages.back());
      }
      writer.flush();
    }
  }
  std::stable_sort(messages.begin(), messages.end(), [](const Message& a, const Message& b) {
    return a.log_time_ns < b.log_time_ns;
  });
  for (const std::size_t held :
       {std::size_t{1}, std::size_t{10'000}, std::size_t{30'000}, chunks_held_bytes}) {
    SCOPED_TRACE(held);
    EXPECT_EQ(all_of(*open_mcap(folder / "a.mcap", held)), messages);
  }
}

TEST(McapBag, LooseMessagesBetweenChunksAreReadWithOrWithoutASummary) {
  const auto payload = level_payload(1);
  for (const bool has_summary : {true, false}) {
    SCOPED_TRACE(has_summary);
    MadeUpMcap definitions;
    definitions.schema(1, level_channel());
    definitions.channel(1, 1, level_channel().topic);
    MadeUpMcap first;
    first.message(1, 30, payload);
    first.message(1, 10, payload);
    MadeUpMcap file;
    file.records.raw(definitions.content());
    file.message(1, 20, payload);
    file.chunk(first);
    file.message(1, 5, payload);
    file.message(1, 40, payload);
    file.end(has_summary ? &definitions : nullptr);
    const TemporaryFolder folder;
    const auto bag = open_bag(write_file(folder / "loose.mcap", file.bytes));
    std::vector<std::int64_t> times;
    for (const Message& message : all_of(*bag)) times.push_back(message.log_time_ns);
    EXPECT_EQ(times, (std::vector<std::int64_t>{5, 10, 20, 30, 40}));
    EXPECT_TRUE(bag->warnings().empty());
  }
}

TEST(McapBag, ALooseFileLargerThanAStretchIsSortedThroughout) {
  MadeUpMcap file;
  file.schema(1, level_channel());
  file.channel(1, 1, level_channel().topic);
  constexpr std::uint64_t count = 5000;
  for (std::uint64_t i = 0; i < count; ++i)
    file.message(1, (i * 1237) % count, noise_payload(i, 1000));
  file.end(nullptr);
  const TemporaryFolder folder;
  const auto messages = all_in(write_file(folder / "loose.mcap", file.bytes));
  ASSERT_EQ(messages.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    ASSERT_EQ(messages[i].log_time_ns, static_cast<std::int64_t>(i));
}

TEST(McapBag, DefinitionsWithinChunksAreFound) {
  MadeUpMcap inside;
  inside.schema(7, level_channel());
  inside.channel(3, 7, level_channel().topic);
  inside.message(3, 1, level_payload(1));
  MadeUpMcap nothing;
  for (const MadeUpMcap* summary : {static_cast<MadeUpMcap*>(nullptr), &nothing}) {
    MadeUpMcap file;
    file.chunk(inside);
    file.end(summary);
    const TemporaryFolder folder;
    const auto messages = all_in(write_file(folder / "inside.mcap", file.bytes));
    ASSERT_EQ(messages.size(), 1U);
    EXPECT_EQ(messages[0].channel.definition, level_channel().definition);
  }
}

TEST(McapBag, Lz4FramesAreRead) {
  MadeUpMcap inside;
  inside.schema(1, level_channel());
  inside.channel(1, 1, level_channel().topic);
  for (std::uint64_t i = 0; i < 3000; ++i) inside.message(1, i, level_payload(1));
  Bytes packed(LZ4F_compressFrameBound(inside.content().size(), nullptr));
  packed.resize(LZ4F_compressFrame(packed.data(), packed.size(), inside.content().data(),
                                   inside.content().size(), nullptr));
  MadeUpMcap file;
  file.chunk(inside, "lz4", packed, inside.content().size());
  file.end(nullptr);
  const TemporaryFolder folder;
  EXPECT_EQ(all_in(write_file(folder / "lz4.mcap", file.bytes)).size(), 3000U);
}

TEST(McapBag, WhatIsNotCdrIsRefusedByName) {
  MadeUpMcap file;
  file.schema(1, {"", "Thing", "{}", {}}, "jsonschema");
  file.channel(1, 1, "/thing", "json");
  file.end(nullptr);
  const TemporaryFolder folder;
  write_file(folder / "json.mcap", file.bytes);
  const std::string said = error_of([&] { return open_bag(folder / "json.mcap"); });
  EXPECT_NE(said.find("topic /thing are encoded as 'json'"), std::string::npos) << said;
}

/// Each lies about itself in one way. Whoever opens it gets an Error or a warning, and never asks
/// for the memory that is claimed.
class LyingMcap : public testing::Test {
 protected:
  LyingMcap() {
    inside_.schema(1, level_channel());
    inside_.channel(1, 1, level_channel().topic);
    inside_.message(1, 1, level_payload(1));
  }
  std::string said_of(const MadeUpMcap& file) const {
    const auto path = write_file(folder_ / "lying.mcap", file.bytes);
    try {
      const auto bag = open_bag(path);
      const auto found = all_of(*bag);
      return bag->warnings().empty() ? "nothing" : bag->warnings().front();
    } catch (const Error& error) {
      return error.message();
    }
  }
  TemporaryFolder folder_;
  MadeUpMcap inside_;
};

TEST_F(LyingMcap, AboutTheSizeOfAChunk) {
  for (const char* compression : {"", "zstd", "lz4"}) {
    MadeUpMcap file;
    file.chunk(inside_, compression, inside_.content(), std::uint64_t{1} << 60U);
    file.end(nullptr);
    EXPECT_NE(said_of(file).find("claims 1152921504606846976 bytes"), std::string::npos)
        << said_of(file);
  }
  MadeUpMcap file;
  file.chunk(inside_, "zstd", inside_.content(), std::uint64_t{400} << 20U);
  file.end(nullptr);
  EXPECT_NE(said_of(file).find("zstd: "), std::string::npos) << said_of(file);
}

TEST_F(LyingMcap, AboutTheLengthOfARecord) {
  MadeUpMcap file;
  file.records.number(std::uint8_t{5});
  file.records.number(~std::uint64_t{0});
  EXPECT_NE(said_of(file).find("goes beyond the end"), std::string::npos) << said_of(file);
}

TEST_F(LyingMcap, AboutWhatComesOutOfAChunk) {
  const Bytes more(inside_.content().begin(), inside_.content().end());
  MadeUpMcap file;
  file.chunk(inside_, "", more, more.size() - 1);
  file.end(nullptr);
  EXPECT_NE(said_of(file).find("claims"), std::string::npos) << said_of(file);
}

TEST_F(LyingMcap, AboutWhereChunksAre) {
  MadeUpMcap file;
  file.chunk(inside_);
  file.chunks[0].offset = 1'000'000;
  file.end(&inside_);
  EXPECT_NE(said_of(file).find("outside the data"), std::string::npos) << said_of(file);
}

TEST_F(LyingMcap, AboutChunksThatLieOverOneAnother) {
  MadeUpMcap file;
  file.chunk(inside_);
  file.chunks.push_back(file.chunks[0]);
  file.end(&inside_);
  EXPECT_NE(said_of(file).find("two chunks at one place"), std::string::npos) << said_of(file);
}

TEST_F(LyingMcap, AboutTheTimesOfAChunk) {
  MadeUpMcap file;
  file.chunk(inside_);
  file.end(&inside_, 2);
  EXPECT_NE(said_of(file).find("earlier than the summary says"), std::string::npos)
      << said_of(file);
}

TEST_F(LyingMcap, AboutAChannel) {
  MadeUpMcap file;
  file.message(9, 1, level_payload(1));
  file.end(nullptr);
  EXPECT_NE(said_of(file).find("channel 9, which is not defined"), std::string::npos)
      << said_of(file);
}

TEST_F(LyingMcap, AboutTheTimeOfAMessage) {
  MadeUpMcap file;
  file.records.raw(inside_.content());
  file.message(1, ~std::uint64_t{0}, level_payload(1));
  file.end(nullptr);
  EXPECT_NE(said_of(file).find("a time of 18446744073709551615 ns"), std::string::npos)
      << said_of(file);
}

TEST_F(LyingMcap, AboutItsCompression) {
  MadeUpMcap file;
  file.chunk(inside_, "rar", inside_.content(), 10);
  file.end(nullptr);
  EXPECT_NE(said_of(file).find("'rar'"), std::string::npos) << said_of(file);
}

}  // namespace
}  // namespace slackwater::bag::tests::mcap_bag_test
