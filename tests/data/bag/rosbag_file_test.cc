#include "data/bag/rosbag_file.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <fstream>

#include "data/store/database.h"
#include "fields/base/error.h"
#include "tests/data/bag/made_up_mcap.h"
#include "tests/support/error_of.h"
#include "tests/support/temporary_folder.h"

namespace slackwater::bag::tests::rosbag_file_test {
namespace {

using slackwater::tests::error_of;
using slackwater::tests::TemporaryFolder;

void run_sql(const std::filesystem::path& file, const std::string& sql) {
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  char* said = nullptr;
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, &said), SQLITE_OK) << said;
  sqlite3_close(database);
}

// As rosbag2 made them: Dashing; Foxy; Galactic and Humble.
const std::string topics_1 =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
    "serialization_format TEXT NOT NULL);";
const std::string topics_2 =
    "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL, "
    "serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);";
const std::string tables_3 =
    "CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);"
    "CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL, "
    "metadata TEXT NOT NULL); INSERT INTO schema VALUES (3, 'humble');";
const std::string messages_table =
    "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, "
    "timestamp INTEGER NOT NULL, data BLOB NOT NULL);"
    "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
const std::string two_messages =
    "INSERT INTO messages VALUES (1, 1, 20, x'0001000000000000000000F03F'), "
    "(2, 1, 10, x'000100000000000000000000');";
const std::string topic_1 = "INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/Float64', 'cdr');";
const std::string topic_2 =
    "INSERT INTO topics VALUES (1, '/a', 'std_msgs/msg/Float64', 'cdr', "
    "'- depth: 3' || char(10) || '  reliability: 2' || char(10) || '  durability: 1');";

TEST(RosbagFile, OfEachOlderVersionIsRead) {
  const std::vector<std::pair<std::string, Quality>> versions{
      {topics_1 + messages_table + topic_1, {}},
      {topics_2 + messages_table + topic_2, {false, true, 3}},
      {tables_3 + topics_2 + messages_table + topic_2, {false, true, 3}}};
  for (const auto& [sql, quality] : versions) {
    SCOPED_TRACE(sql);
    const TemporaryFolder folder;
    run_sql(folder / "a.db3", sql + two_messages);
    const auto bag = open_bag(folder / "a.db3");
    EXPECT_EQ(bag->channels(), (std::vector<Channel>{{"/a", "std_msgs/msg/Float64", "", quality}}));
    const auto messages = all_of(*bag);
    ASSERT_EQ(messages.size(), 2U);
    EXPECT_EQ(messages[0].log_time_ns, 10);
    EXPECT_EQ(messages[0].payload, level_payload(0));
    EXPECT_EQ(messages[1].log_time_ns, 20);
  }
}

TEST(RosbagFile, WithAWriteAheadLogIsRead) {
  // rosbag2's preset "resilient", its writer gone without closing.
  const TemporaryFolder folder;
  const auto file = folder / "a.db3";
  sqlite3* database = nullptr;
  ASSERT_EQ(sqlite3_open(file.c_str(), &database), SQLITE_OK);
  const std::string sql =
      "PRAGMA journal_mode = WAL;" + topics_1 + messages_table + topic_1 + two_messages;
  ASSERT_EQ(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK);
  for (const char* ending : {"", "-wal"})
    std::filesystem::copy_file(file.string() + ending, (folder / "left.db3").string() + ending);
  sqlite3_close(database);
  EXPECT_EQ(all_in(folder / "left.db3").size(), 2U);
}

TEST(RosbagFile, WhatIsNotCdrIsRefusedByName) {
  const TemporaryFolder folder;
  run_sql(folder / "a.db3", topics_1 + messages_table +
                                "INSERT INTO topics VALUES (1, '/a', 'b/msg/C', 'protobuf');");
  const std::string said = error_of([&] { return open_bag(folder / "a.db3"); });
  EXPECT_NE(said.find("topic /a are encoded as 'protobuf'"), std::string::npos) << said;
}

TEST(RosbagFile, OtherDatabasesAreRefused) {
  const std::vector<std::string> others{
      "CREATE TABLE something(a);", topics_1,
      topics_1 + "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id);",
      // Views and generated columns run what the file brings along.
      topics_1 +
          "CREATE VIEW messages(id, topic_id, timestamp, data) AS WITH RECURSIVE n(i) AS "
          "(SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT i, 1, i, x'00' FROM n;",
      topics_1 +
          "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, "
          "data AS (zeroblob(1000000000)));"};
  for (const std::string& sql : others) {
    SCOPED_TRACE(sql);
    const TemporaryFolder folder;
    run_sql(folder / "a.db3", sql);
    try {
      static_cast<void>(open_bag(folder / "a.db3"));
      ADD_FAILURE() << "was opened";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input);
      EXPECT_NE(error.message().find("no recording of rosbag2"), std::string::npos)
          << error.message();
    }
  }
}

TEST(RosbagFile, AMessageOfNoTopicIsDamage) {
  const TemporaryFolder folder;
  run_sql(folder / "a.db3", topics_1 + messages_table + two_messages);
  const std::string said = error_of([&] { return all_in(folder / "a.db3"); });
  EXPECT_NE(said.find("message 2 is of topic 1, which is not in its table"), std::string::npos)
      << said;
}

/// A time before 1970 is no time of a log, as in MCAP, and no difference of two can overflow.
TEST(RosbagFile, ATimeBefore1970IsDamage) {
  const TemporaryFolder folder;
  run_sql(folder / "a.db3", topics_1 + messages_table + topic_1 +
                                "INSERT INTO messages VALUES "
                                "(1, 1, -9223372036854775808, x'00010000'), "
                                "(2, 1, 9223372036854775807, x'00010000');");
  const std::string said = error_of([&] { return all_in(folder / "a.db3"); });
  EXPECT_NE(said.find("message 1 is of a time of -9223372036854775808 ns"), std::string::npos)
      << said;
}

/// A file of SQLite, page by page (its file format, sections 1.6 and 2).
class Pages {
 public:
  explicit Pages(const std::filesystem::path& file) : bytes_(bytes_of(file)) {}
  [[nodiscard]] const Bytes& bytes() const { return bytes_; }

  /// Pages of a tree with so many levels, all of one child: its root names one page again and
  /// again, that one the next, the last a leaf.
  void tie(std::size_t root, std::size_t levels) {
    std::vector<std::size_t> others;
    for (const std::size_t at : children(root)) others.push_back(number(at));
    ASSERT_GT(others.size(), levels);
    const Bytes form(page(root), page(root) + size);
    for (std::size_t level = 1; level < levels; ++level)
      std::copy(form.begin(), form.end(), page(others[level]));
    std::size_t above = root;
    for (std::size_t level = 1; level <= levels; ++level) {
      const std::size_t below = level < levels ? others[level] : others[0];
      for (const std::size_t at : children(above))
        for (std::size_t i = 0; i < 4; ++i)
          bytes_[at + i] = static_cast<std::uint8_t>(below >> (24 - 8 * i));
      above = below;
    }
  }

 private:
  static constexpr std::size_t size = 512;
  [[nodiscard]] static std::size_t start(std::size_t page) { return (page - 1) * size; }
  [[nodiscard]] Bytes::iterator page(std::size_t page) {
    return bytes_.begin() + static_cast<std::ptrdiff_t>(start(page));
  }
  [[nodiscard]] std::size_t short_number(std::size_t at) const {
    return static_cast<std::size_t>(bytes_[at] << 8U | bytes_[at + 1]);
  }
  [[nodiscard]] std::size_t number(std::size_t at) const {
    return short_number(at) << 16U | short_number(at + 2);
  }
  /// Where a page that is no leaf names those below it.
  [[nodiscard]] std::vector<std::size_t> children(std::size_t page) const {
    std::vector<std::size_t> places{start(page) + 8};
    for (std::size_t cell = 0; cell < short_number(start(page) + 3); ++cell)
      places.push_back(start(page) + short_number(start(page) + 12 + 2 * cell));
    return places;
  }

  Bytes bytes_;
};

std::size_t root_of(const std::filesystem::path& file, const std::string& name) {
  auto database = store::Database::open(file, store::Database::Access::read);
  auto root = database.prepare("SELECT rootpage FROM sqlite_schema WHERE name = ?1");
  root.bind(1, name).step();
  return static_cast<std::size_t>(root.integer(0));
}

/// Twenty children to each page, eighteen levels: more messages than anybody will live to read.
TEST(RosbagFile, PagesThatAreNamedAgainAndAgainAreDamage) {
  const std::string index = "CREATE INDEX timestamp_idx ON messages (timestamp ASC);";
  ASSERT_TRUE(messages_table.ends_with(index));
  const std::string plain_table = messages_table.substr(0, messages_table.size() - index.size());
  struct Case {
    std::string table, tied, said;
  };
  for (const Case& c :
       {Case{messages_table, "timestamp_idx", "comes twice, or before its time"},
        Case{plain_table, "messages", "takes more work than a file of its size can ask for"}}) {
    SCOPED_TRACE(c.tied);
    const TemporaryFolder folder;
    const auto file = folder / "a.db3";
    run_sql(file, "PRAGMA page_size = 512;" + topics_1 + c.table + topic_1 +
                      "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n LIMIT 1000) "
                      "INSERT INTO messages SELECT i, 1, 1000000 + i, x'00010000' FROM n;");
    ASSERT_EQ(all_in(file).size(), 1000U);
    Pages pages(file);
    pages.tie(root_of(file, c.tied), 18);
    write_file(file, pages.bytes());
    const std::string said = error_of([&] { return all_in(file); });
    EXPECT_NE(said.find(c.said), std::string::npos) << said;
  }
}

/// Bytes changed and cut at many places: an Error or messages, never anything else.
TEST(RosbagFile, DamagedAnywhereIsReadOrRefused) {
  const TemporaryFolder folder;
  {
    Writer writer = open_recording(folder / "run");
    for (const Message& message : some_messages(60)) write(writer, message);
  }
  const Bytes whole = bytes_of(folder / "run" / "run_0.db3");
  std::size_t refused = 0;
  const auto try_bytes = [&](const Bytes& bytes) {
    try {
      static_cast<void>(all_in(write_file(folder / "damaged.db3", bytes)));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::invalid_input) << error.message();
      ++refused;
    }
  };
  for (std::size_t at = 0; at < whole.size(); at += at < 200 ? 1 : 61) {
    Bytes damaged = whole;
    damaged[at] ^= 0x41U;
    try_bytes(damaged);
  }
  for (std::size_t length = 16; length < whole.size(); length += 509)
    try_bytes({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(length)});
  EXPECT_GT(refused, 50U);
}

TEST(RosbagFolder, OfSeveralFilesIsOneRecording) {
  const TemporaryFolder folder;
  const auto bag = folder / "split";
  std::filesystem::create_directory(bag);
  // Times that overlap, a topic that is in one file alone, ids that differ.
  run_sql(bag / "split_0.db3", topics_1 + messages_table + topic_1 +
                                   "INSERT INTO messages VALUES (1, 1, 10, x'00010000'), "
                                   "(2, 1, 30, x'00010000'), (3, 1, 50, x'00010000');");
  run_sql(bag / "split_1.db3",
          topics_1 + messages_table +
              "INSERT INTO topics VALUES (1, '/b', 'std_msgs/msg/Float64', 'cdr'), "
              "(2, '/a', 'std_msgs/msg/Float64', 'cdr');"
              "INSERT INTO messages VALUES (1, 1, 20, x'00010000'), (2, 2, 50, x'00010001'), "
              "(3, 2, 60, x'00010000');");
  const auto expect_all = [&] {
    const auto messages = all_in(bag);
    std::string found;
    for (const Message& m : messages)
      found += m.channel.topic + std::to_string(m.log_time_ns) + " ";
    EXPECT_EQ(found, "/a10 /b20 /a30 /a50 /a50 /a60 ");
    EXPECT_EQ(messages[4].payload[3], 1);
  };
  expect_all();
  // Up to version 3 of metadata.yaml the names began with the folder's.
  std::ofstream(bag / "metadata.yaml")
      << "rosbag2_bagfile_information:\n  version: 3\n  storage_identifier: sqlite3\n"
         "  relative_file_paths:\n    - split/split_0.db3\n    - split/split_1.db3\n"
         "  compression_format: \"\"\n  compression_mode: \"\"\n";
  expect_all();
  std::filesystem::remove(bag / "split_1.db3");
  const std::string said = error_of([&] { return open_bag(bag); });
  EXPECT_NE(said.find("names split_1.db3, which is not there"), std::string::npos) << said;
  std::ofstream(bag / "metadata.yaml").flush();
  EXPECT_EQ(all_in(bag).size(), 3U) << "an empty one is none";
}

TEST(RosbagFolder, OfMcapFilesIsRead) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "bag");
  const auto messages = some_messages(30);
  std::size_t written = 0;
  for (const char* name : {"bag_9.mcap", "bag_10.mcap"}) {
    Writer writer = open_recording(folder / "bag" / name);
    for (std::size_t i = 0; i < messages.size() / 2; ++i) write(writer, messages[written++]);
  }
  EXPECT_EQ(all_in(folder / "bag"),
            std::vector<Message>(messages.begin(),
                                 messages.begin() + static_cast<std::ptrdiff_t>(written)));
}

TEST(RosbagFolder, CompressedByRosbagIsRefusedWithAdvice) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "bag");
  std::ofstream(folder / "bag" / "metadata.yaml")
      << "rosbag2_bagfile_information:\n  version: 4\n  relative_file_paths: [a.db3.zstd]\n"
         "  compression_format: zstd\n  compression_mode: FILE\n";
  const std::string said = error_of([&] { return open_bag(folder / "bag"); });
  EXPECT_NE(said.find("ros2 bag convert"), std::string::npos) << said;
}

}  // namespace
}  // namespace slackwater::bag::tests::rosbag_file_test
