#include "data/bag/rosbag_file.h"

#include <map>

#include "data/bag/channel_table.h"
#include "data/bag/quality_yaml.h"
#include "data/store/database.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

using store::Database;
using store::Statement;

constexpr store::DatabaseWords words{
    .name = "the recording",
    .when_full = "free some space and try again",
    .when_locked = "wait until its writer is done and try again",
    .when_not_writable =
        "its writer was interrupted, and what it left half done must be taken back: give write "
        "permission on the file and its folder, or copy them",
    .when_failing = "check the disk and try again",
    .when_damaged = "only what stands before the damage can be read"};

/// SQLite's general error is the file's here, not ours: its tables are a stranger's.
template <typename Work>
decltype(auto) of_a_stranger(const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::internal) throw;
    throw Error(ErrorKind::invalid_input, error.message() + "; it is no recording of rosbag2");
  }
}

bool is_there(const std::filesystem::path& file) {
  std::error_code none;
  return std::filesystem::exists(file, none) && std::filesystem::file_size(file, none) > 0;
}

void look(Database& database) {
  auto any = database.prepare("SELECT count(*) FROM sqlite_schema");
  any.step();
}

Database opened(const std::filesystem::path& file) {
  // A journal that was left behind: whoever opens the file for writing takes the half-done
  // transaction back. While its writer lives there is nothing to take back, and nothing happens.
  if (is_there(file.string() + "-journal")) {
    Database database = Database::open(file, Database::Access::write, words);
    look(database);
  }
  try {
    Database database = Database::open(file, Database::Access::read, words);
    look(database);
    return database;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::unavailable || !is_there(file.string() + "-wal")) throw;
    return Database::open(file, Database::Access::read_orphaned_wal, words);
  }
}

class RosbagFile : public Bag {
 public:
  explicit RosbagFile(const std::filesystem::path& file) : database_(opened(file)) {
    database_.execute("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
    expect_table("topics", {"id", "name", "type", "serialization_format"});
    expect_table("messages", {"id", "topic_id", "timestamp", "data"});
    read_channels();
    messages_.emplace(database_.prepare(
        "SELECT topic_id, timestamp, data, id FROM messages ORDER BY timestamp, id"));
  }

  const std::vector<Channel>& channels() const noexcept override { return table_.channels(); }
  const std::vector<std::string>& warnings() const noexcept override { return warnings_; }

  std::optional<Recorded> next() override {
    if (!messages_) return std::nullopt;
    try {
      if (of_a_stranger([&] { return messages_->step(); })) return message();
    } catch (const Error&) {
      messages_.reset();
      throw;
    }
    messages_.reset();
    return std::nullopt;
  }

 private:
  Recorded message() const {
    const std::int64_t topic = messages_->integer(0);
    const std::size_t* channel = table_.find(topic);
    if (channel == nullptr) {
      throw Error(ErrorKind::invalid_input,
                  "the recording " + database_.file().string() + ": message " +
                      std::to_string(messages_->integer(3)) + " is of topic " +
                      std::to_string(topic) + ", which is not in its table of topics");
    }
    return {*channel, messages_->integer(1), messages_->bytes(2)};
  }

  /// A plain table with these columns.
  void expect_table(const std::string& name, const std::vector<std::string>& columns) {
    auto table = database_.prepare(
        "SELECT count(*) FROM sqlite_schema WHERE type = 'table' AND name = ?1 AND rootpage > 0");
    table.bind(1, name).step();
    const auto found = columns_of(name);
    bool fits = table.integer(0) == 1;
    for (const std::string& column : columns) fits = fits && found.contains(column);
    for (const auto& [column, is_plain] : found) fits = fits && is_plain;
    if (fits) return;
    throw Error(ErrorKind::invalid_input,
                "the recording " + database_.file().string() + ": it has no table '" + name +
                    "' of the form that rosbag2 writes; it is no recording of rosbag2");
  }

  std::map<std::string, bool> columns_of(const std::string& table) {
    std::map<std::string, bool> columns;
    auto rows = database_.prepare("SELECT name, hidden FROM pragma_table_xinfo(?1)");
    rows.bind(1, table);
    while (rows.step()) columns[rows.text(0)] = rows.integer(1) == 0;
    return columns;
  }

  void read_channels() {
    std::map<std::string, std::string> definitions;
    if (!columns_of("message_definitions").empty()) {
      expect_table("message_definitions", {"topic_type", "encoding", "encoded_message_definition"});
      auto rows = database_.prepare(
          "SELECT topic_type, encoded_message_definition FROM message_definitions "
          "WHERE encoding = 'ros2msg'");
      while (rows.step()) definitions.try_emplace(rows.text(0), rows.text(1));
    }
    const bool has_quality = columns_of("topics").contains("offered_qos_profiles");
    auto rows = database_.prepare("SELECT id, name, type, serialization_format, " +
                                  std::string(has_quality ? "offered_qos_profiles" : "''") +
                                  " FROM topics ORDER BY id");
    while (rows.step()) {
      Channel channel{rows.text(1), rows.text(2), {}, quality_of(rows.text(4))};
      expect_cdr(channel.topic, rows.text(3));
      if (const auto known = definitions.find(channel.type); known != definitions.end())
        channel.definition = known->second;
      table_.name(rows.integer(0), table_.add(channel));
    }
  }

  Database database_;
  ChannelTable table_;
  std::optional<Statement> messages_;
  std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<Bag> open_rosbag_file(const std::filesystem::path& file) {
  return of_a_stranger([&] { return std::make_unique<RosbagFile>(file); });
}

}  // namespace slackwater::bag
