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

constexpr store::DatabaseWords words_of_reader{
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
  auto any = database.prepare("SELECT 1 FROM sqlite_schema LIMIT 1");
  any.step();
}

/// No row takes less than some ten bytes of a file, nor more than some forty operations.
constexpr std::uint64_t operations_per_byte = 10, operations_in_any_case = 1'000'000;
void bound_work(Database& database, std::uint64_t bytes) {
  database.bound_work(operations_in_any_case + operations_per_byte * bytes);
}

/// Of all files that a database lies in.
std::uint64_t bytes_of(const std::filesystem::path& file) {
  std::uint64_t bytes = 0;
  for (const char* ending : {"", "-wal"}) {
    std::error_code none;
    const auto size = std::filesystem::file_size(file.string() + ending, none);
    if (!none) bytes += size;
  }
  return bytes;
}

/// A connection that reads what is in the file, and not what pages that are named twice make of it.
Database bounded(const std::filesystem::path& file, Database::Access access) {
  Database database = Database::open(file, access, words_of_reader);
  bound_work(database, bytes_of(file));
  return database;
}

Database opened(const std::filesystem::path& file) {
  // A journal that was left behind: whoever opens the file for writing takes the half-done
  // transaction back. While its writer lives there is nothing to take back, and nothing happens.
  if (is_there(file.string() + "-journal")) {
    Database database = bounded(file, Database::Access::write);
    look(database);
  }
  try {
    Database database = bounded(file, Database::Access::read);
    look(database);
    return database;
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::unavailable || !is_there(file.string() + "-wal")) throw;
    return bounded(file, Database::Access::read_orphaned_wal);
  }
}

/// When a message comes, and which it is: no two are alike.
struct Turn {
  std::int64_t time_ns = 0;
  std::int64_t row = 0;
  auto operator<=>(const Turn&) const = default;
};

/// Pages of a damaged file may be named by several others, or by one below them: what is read of it
/// then never ends. So each message comes once, all texts and messages together are no longer than
/// the file, and no more work is done than it can ask for.
class RosbagFile : public Bag {
 public:
  explicit RosbagFile(const std::filesystem::path& file) : database_(opened(file)) {
    database_.execute("PRAGMA trusted_schema = OFF; PRAGMA cell_size_check = ON");
    expect_table("topics", {"id", "name", "type", "serialization_format"});
    expect_table("messages", {"id", "topic_id", "timestamp", "data"});
    read_channels();
    turns_.emplace(
        database_.prepare("SELECT timestamp, rowid FROM messages ORDER BY timestamp, rowid"));
    message_.emplace(database_.prepare("SELECT topic_id, data FROM messages WHERE rowid = ?1"));
  }

  const std::vector<Channel>& channels() const noexcept override { return table_.channels(); }
  const std::vector<std::string>& warnings() const noexcept override { return warnings_; }

  std::optional<Recorded> next() override {
    if (!turns_) return std::nullopt;
    try {
      if (of_a_stranger([&] { return has_next(); }))
        return of_a_stranger([&] { return message(); });
    } catch (const Error&) {
      end();
      throw;
    }
    end();
    return std::nullopt;
  }

 private:
  void end() {
    message_.reset();
    turns_.reset();
  }

  [[noreturn]] void damaged(const std::string& what) const {
    throw Error(ErrorKind::invalid_input, "the recording " + database_.file().string() + ": " +
                                              what + "; " +
                                              std::string(words_of_reader.when_damaged));
  }
  [[noreturn]] void damaged(std::int64_t row, const std::string& what) const {
    damaged("message " + std::to_string(row) + " " + what);
  }

  /// Counts what was read of the file against its size.
  void take(std::size_t bytes) {
    if (bytes > bytes_left_) damaged("more is in it than its size allows");
    bytes_left_ -= bytes;
  }

  /// Since it was opened it may have grown.
  void begin() {
    message_->reset();
    const std::uint64_t bytes = bytes_of(database_.file());
    bytes_left_ = bytes;
    bound_work(database_, bytes);
    has_begun_ = true;
  }

  bool has_next() {
    if (!has_begun_) begin();
    message_->reset();
    return turns_->step();
  }

  Recorded message() {
    const Turn turn{turns_->integer(0), turns_->integer(1)};
    if (turn.time_ns < 0)
      damaged(turn.row, "is of a time of " + std::to_string(turn.time_ns) + " ns");
    if (last_ && turn <= *last_) damaged(turn.row, "comes twice, or before its time");
    last_ = turn;
    message_->bind(1, turn.row);
    if (!message_->step()) damaged(turn.row, "is in the index of times alone");
    const std::int64_t topic = message_->integer(0);
    const std::size_t* channel = table_.find(topic);
    if (channel == nullptr) {
      damaged(turn.row,
              "is of topic " + std::to_string(topic) + ", which is not in its table of topics");
    }
    const Payload payload = message_->bytes(1);
    take(payload.size());
    return {*channel, turn.time_ns, payload};
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
      while (rows.step()) {
        const std::string definition = rows.text(1);
        take(definition.size());
        definitions.try_emplace(rows.text(0), definition);
      }
    }
    const bool has_quality = columns_of("topics").contains("offered_qos_profiles");
    auto rows = database_.prepare("SELECT id, name, type, serialization_format, " +
                                  std::string(has_quality ? "offered_qos_profiles" : "''") +
                                  " FROM topics ORDER BY id");
    while (rows.step()) {
      const std::string quality = rows.text(4);
      Channel channel{rows.text(1), rows.text(2), {}, {}};
      take(channel.topic.size() + channel.type.size() + quality.size());
      channel.quality = quality_of(quality);
      expect_cdr(channel.topic, rows.text(3));
      if (const auto known = definitions.find(channel.type); known != definitions.end())
        channel.definition = known->second;
      table_.name(rows.integer(0), table_.add(channel));
    }
  }

  Database database_;
  ChannelTable table_;
  std::uint64_t bytes_left_ = bytes_of(database_.file());
  bool has_begun_ = false;
  std::optional<Turn> last_;
  std::optional<Statement> turns_;    ///< of all messages, by time
  std::optional<Statement> message_;  ///< that which comes next
  std::vector<std::string> warnings_;
};

}  // namespace

std::unique_ptr<Bag> open_rosbag_file(const std::filesystem::path& file) {
  return of_a_stranger([&] { return std::make_unique<RosbagFile>(file); });
}

}  // namespace slackwater::bag
