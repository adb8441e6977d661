#include "data/bag/mcap_format.h"

#include <map>
#include <vector>

#include "data/bag/append_file.h"
#include "data/bag/chunk_codec.h"
#include "data/bag/crc32.h"
#include "data/bag/mcap_ending.h"
#include "data/bag/mcap_record.h"
#include "data/bag/quality_yaml.h"
#include "data/bag/type_hash.h"
#include "data/store/durable.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

struct IndexEntry {
  std::int64_t log_time_ns = 0;
  std::uint64_t offset = 0;  ///< in the chunk's records, unpacked
};

struct KnownChannel {
  std::vector<IndexEntry> index;  ///< of the chunk at hand
  std::uint32_t sequence = 0;
};

void put_time(McapRecords& records, std::int64_t time_ns) {
  records.number(static_cast<std::uint64_t>(time_ns));
}

class McapFormat : public RecordingFormat {
 public:
  McapFormat(std::filesystem::path folder, AppendFile file)
      : folder_(std::move(folder)), file_(std::move(file)) {
    Bytes start(mcap_magic.begin(), mcap_magic.end());
    McapRecords records(start);
    records.begin(McapOp::header);
    records.text("ros2");
    records.text("slackwater");
    records.end();
    file_.append(start);
  }

  void add_channel(std::uint16_t id, const Channel& channel) override {
    piece_.clear();
    McapRecords records(piece_);
    const auto [schema, is_new] =
        schema_ids_.try_emplace(channel.type, static_cast<std::uint16_t>(schema_ids_.size() + 1));
    if (is_new) {
      records.begin(McapOp::schema);
      records.number(schema->second);
      records.text(channel.type);
      records.text("ros2msg");
      records.text(channel.definition);
      records.end();
    }
    const std::size_t schema_bytes = piece_.size();
    records.begin(McapOp::channel);
    records.number(id);
    records.number(schema->second);
    records.text(channel.topic);
    records.text("cdr");
    records.begin_list();
    records.text("offered_qos_profiles");
    records.text(yaml_of(channel.quality));
    if (const auto hash = type_hash(channel.type, channel.definition)) {
      records.text("topic_type_hash");
      records.text(*hash);
    }
    records.end_list();
    records.end();
    file_.append(piece_);
    if (is_new) ending_.take_schema(ByteView(piece_).first(schema_bytes));
    ending_.take_channel(ByteView(piece_).subspan(schema_bytes));
    known_.emplace_back();
  }

  void append(std::uint16_t id, std::int64_t log_time_ns, Payload payload) override {
    KnownChannel& channel = known_[id - 1U];
    channel.index.push_back({log_time_ns, chunk_.size()});
    McapRecords records(chunk_);
    records.begin(McapOp::message);
    records.number(id);
    records.number(channel.sequence++);
    put_time(records, log_time_ns);
    put_time(records, log_time_ns);  // when it was published
    records.raw(payload);
    records.end();
    times_.take(log_time_ns);
  }

  void end_batch() override {
    if (chunk_.empty()) return;
    piece_.clear();
    McapRecords records(piece_);
    records.begin(McapOp::chunk);
    put_time(records, times_.first_ns);
    put_time(records, times_.last_ns);
    records.number(std::uint64_t{chunk_.size()});
    records.number(crc32(chunk_));
    records.text("zstd");
    packed_.clear();
    packer_.pack(chunk_, packed_);
    records.number(std::uint64_t{packed_.size()});
    records.raw(packed_);
    records.end();
    write_chunk();
    discard_batch();
  }

  void discard_batch() noexcept override {
    chunk_.clear();
    times_ = {};
    for (KnownChannel& channel : known_) channel.index.clear();
  }

  void finish() override {
    piece_.clear();
    ending_.write(file_.size(), piece_);
    file_.append(piece_);
    file_.sync();
    store::sync_folder(folder_);
  }

 private:
  /// The chunk in `piece_` and its message indexes, at one stroke.
  void write_chunk() {
    McapChunk chunk{times_, file_.size(), piece_.size(), 0, packed_.size(), chunk_.size(), {}};
    McapRecords records(piece_);
    McapRecords offsets(chunk.index_offsets);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (known_[i].index.empty()) continue;
      const auto id = static_cast<std::uint16_t>(i + 1);
      offsets.number(id);
      offsets.number(chunk.offset + piece_.size());
      records.begin(McapOp::message_index);
      records.number(id);
      records.begin_list();
      for (const IndexEntry& entry : known_[i].index) {
        put_time(records, entry.log_time_ns);
        records.number(entry.offset);
      }
      records.end_list();
      records.end();
    }
    chunk.indexes_length = piece_.size() - chunk.length;
    file_.append(piece_);
    ending_.take_chunk(chunk);
    for (std::size_t i = 0; i < known_.size(); ++i)
      ending_.count(static_cast<std::uint16_t>(i + 1), known_[i].index.size());
  }

  std::filesystem::path folder_;
  AppendFile file_;
  ZstdPacker packer_;
  std::map<std::string, std::uint16_t> schema_ids_;
  std::vector<KnownChannel> known_;
  Bytes chunk_;  ///< records at hand
  McapTimes times_;
  Bytes piece_;
  Bytes packed_;
  McapEnding ending_;
};

}  // namespace

std::unique_ptr<RecordingFormat> begin_mcap(const std::filesystem::path& file) {
  AppendFile begun(file);
  try {
    return std::make_unique<McapFormat>(file.has_parent_path() ? file.parent_path() : ".",
                                        std::move(begun));
  } catch (const Error&) {
    std::error_code ignored;
    std::filesystem::remove(file, ignored);
    throw;
  }
}

}  // namespace slackwater::bag
