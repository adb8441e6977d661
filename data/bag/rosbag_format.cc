#include "data/bag/rosbag_format.h"

#include <sys/stat.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <optional>
#include <set>
#include <string>

#include "data/bag/append_file.h"
#include "data/bag/quality_yaml.h"
#include "data/bag/rosbag_metadata.h"
#include "data/bag/type_hash.h"
#include "data/store/database.h"
#include "data/store/durable.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

constexpr store::DatabaseWords words{
    .name = "the recording",
    .when_full = "what was recorded before stays readable; free some space and begin a new one",
    .when_locked = "leave it alone while it is being recorded",
    .when_not_writable = "give write permission on its folder, and begin a new recording",
    .when_failing = "what was recorded before stays readable; mend the disk and begin a new one",
    .when_damaged = "leave it alone while it is being recorded"};

// As rosbag2_storage_sqlite3 makes it since Iron. The cache holds a batch, so that nothing of it
// reaches the file before it is committed.
constexpr const char* tables = R"sql(
PRAGMA journal_mode = DELETE;
PRAGMA synchronous = NORMAL;
PRAGMA cache_size = -32768;
BEGIN;
CREATE TABLE schema(schema_version INTEGER PRIMARY KEY, ros_distro TEXT NOT NULL);
CREATE TABLE metadata(id INTEGER PRIMARY KEY, metadata_version INTEGER NOT NULL,
                      metadata TEXT NOT NULL);
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
                    serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL,
                    type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,
                                 encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL,
                                 type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,
                      timestamp INTEGER NOT NULL, data BLOB NOT NULL);
CREATE INDEX timestamp_idx ON messages(timestamp ASC);
INSERT INTO schema(schema_version, ros_distro) VALUES (4, '');
COMMIT;
)sql";

void make_folder(const std::filesystem::path& folder) {
  if (::mkdir(folder.c_str(), 0777) != 0) {
    if (errno == EEXIST) refuse_existing(folder);
    throw Error(ErrorKind::unavailable,
                "the recording " + folder.string() + " cannot be made: " + std::strerror(errno) +
                    "; check that the folder above it is there and may be written");
  }
}

class RosbagFormat : public RecordingFormat {
 public:
  explicit RosbagFormat(const std::filesystem::path& folder)
      : folder_(folder),
        database_(store::Database::open(folder_ / (folder_.filename().string() + "_0.db3"),
                                        store::Database::Access::write, words)) {
    metadata_.file = database_.file().filename().string();
    database_.execute(tables);
    insert_message_.emplace(
        database_.prepare("INSERT INTO messages(topic_id, timestamp, data) VALUES (?1, ?2, ?3)"));
    // Readers of Jazzy and later take the qualities for those of this version.
    auto insert = database_.prepare("INSERT INTO metadata VALUES (1, ?1, ?2)");
    insert.bind_all(std::int64_t{rosbag_metadata_version}, metadata_yaml(metadata_)).run();
    write_metadata_file();
  }

  void add_channel(std::uint16_t id, const Channel& channel) override {
    begin();
    const auto hash = type_hash(channel.type, channel.definition);
    auto topic = database_.prepare("INSERT INTO topics VALUES (?1, ?2, ?3, 'cdr', ?4, ?5)");
    topic
        .bind_all(std::int64_t{id}, channel.topic, channel.type, yaml_of(channel.quality),
                  hash.value_or(""))
        .run();
    // Some readers hold the hash against the definition, and refuse the file where it is not right.
    if (hash && types_.insert(channel.type).second) {
      auto definition = database_.prepare(
          "INSERT INTO message_definitions(topic_type, encoding, encoded_message_definition, "
          "type_description_hash) VALUES (?1, 'ros2msg', ?2, ?3)");
      definition.bind_all(channel.type, channel.definition, *hash).run();
    }
    metadata_.topics.push_back({channel, 0});
    metadata_.topics.back().channel.definition.clear();  // not of the metadata
  }

  void append(std::uint16_t id, std::int64_t log_time_ns, Payload payload) override {
    begin();
    insert_message_->bind(1, std::int64_t{id}).bind(2, log_time_ns).bind_bytes(3, payload).run();
    const bool is_first = metadata_.messages == 0;
    metadata_.first_ns = is_first ? log_time_ns : std::min(metadata_.first_ns, log_time_ns);
    metadata_.last_ns = is_first ? log_time_ns : std::max(metadata_.last_ns, log_time_ns);
    ++metadata_.messages;
    ++metadata_.topics[id - 1U].messages;
  }

  void end_batch() override {
    if (!batch_) return;
    batch_->commit();
    batch_.reset();
    committed_ = metadata_;
    write_metadata_file();
  }

  void discard_batch() noexcept override {
    insert_message_->reset();
    batch_.reset();
    metadata_ = committed_;
  }

  void finish() override {
    auto update = database_.prepare("UPDATE metadata SET metadata = ?1");
    update.bind(1, metadata_yaml(metadata_)).run();
    write_metadata_file(true);
    store::sync_file(database_.file());
    store::sync_folder(folder_);
  }

 private:
  void begin() {
    if (!batch_) batch_.emplace(database_, store::Transaction::Kind::write);
  }

  /// Replaced as a whole: whoever opens the folder finds the one before or this one. While
  /// recording it is not waited for: the messages are in the database.
  void write_metadata_file(bool is_last = false) const {
    const auto next = folder_ / ".metadata.yaml.next";
    std::filesystem::remove(next);
    const std::string text = metadata_file(metadata_);
    AppendFile file(next);
    file.append({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    if (is_last) file.sync();
    store::rename_file(next, folder_ / "metadata.yaml");
  }

  std::filesystem::path folder_;
  store::Database database_;
  std::optional<store::Statement> insert_message_;
  std::optional<store::Transaction> batch_;
  RosbagMetadata metadata_;   ///< with the batch at hand
  RosbagMetadata committed_;  ///< without it
  std::set<std::string> types_;
};

}  // namespace

std::unique_ptr<RecordingFormat> begin_rosbag(const std::filesystem::path& folder) {
  const auto name = folder.has_filename() ? folder : folder.parent_path();
  make_folder(name);
  try {
    return std::make_unique<RosbagFormat>(name);
  } catch (const Error&) {
    std::error_code ignored;
    std::filesystem::remove_all(name, ignored);
    throw;
  }
}

}  // namespace slackwater::bag
