#include "data/bag/mcap_format.h"

#include <algorithm>
#include <limits>
#include <map>
#include <vector>

#include "data/bag/append_file.h"
#include "data/bag/chunk_codec.h"
#include "data/bag/crc32.h"
#include "data/bag/mcap_record.h"
#include "data/bag/quality_yaml.h"
#include "data/bag/type_hash.h"
#include "data/store/durable.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

/// Of messages, in nanoseconds; 0 and 0 where there are none.
struct Times {
  std::int64_t first = 0;
  std::int64_t last = 0;
  bool is_empty = true;

  void take(std::int64_t time) {
    first = is_empty ? time : std::min(first, time);
    last = is_empty ? time : std::max(last, time);
    is_empty = false;
  }
};

struct IndexEntry {
  std::int64_t log_time_ns = 0;
  std::uint64_t offset = 0;  ///< in the chunk's records, unpacked
};

struct KnownChannel {
  std::vector<IndexEntry> index;  ///< of the chunk at hand
  std::uint64_t messages = 0;     ///< that reached the file
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
    const auto border = piece_.begin() + static_cast<std::ptrdiff_t>(schema_bytes);
    schemas_.insert(schemas_.end(), piece_.begin(), border);
    channels_.insert(channels_.end(), border, piece_.end());
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
    put_time(records, times_.first);
    put_time(records, times_.last);
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
    McapRecords records(piece_);
    records.begin(McapOp::data_end);
    records.number(std::uint32_t{0});  // no sum of the whole: each chunk has its own
    records.end();
    const std::size_t summary = piece_.size();
    write_summary(records);
    records.begin(McapOp::footer);
    records.number(file_.size() + summary);
    records.number(file_.size() + summary_offsets_);
    records.number(std::uint32_t{0});
    records.end();
    // The sum is of all that stands between the summary's first byte and the sum itself.
    piece_.resize(piece_.size() - 4);
    records.number(crc32(ByteView(piece_).subspan(summary)));
    records.raw(mcap_magic);
    file_.append(piece_);
    file_.sync();
    store::sync_folder(folder_);
  }

 private:
  /// The chunk in `piece_` and its message indexes, at one stroke; then what the summary will say.
  void write_chunk() {
    const std::uint64_t start = file_.size();
    const std::uint64_t chunk_length = piece_.size();
    McapRecords records(piece_);
    Bytes offsets;
    McapRecords offset_list(offsets);
    for (std::size_t i = 0; i < known_.size(); ++i) {
      if (known_[i].index.empty()) continue;
      const auto id = static_cast<std::uint16_t>(i + 1);
      offset_list.number(id);
      offset_list.number(start + piece_.size());
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
    file_.append(piece_);

    McapRecords index(chunk_indexes_);
    index.begin(McapOp::chunk_index);
    put_time(index, times_.first);
    put_time(index, times_.last);
    index.number(start);
    index.number(chunk_length);
    index.number(static_cast<std::uint32_t>(offsets.size()));
    index.raw(offsets);
    index.number(piece_.size() - chunk_length);
    index.text("zstd");
    index.number(std::uint64_t{packed_.size()});
    index.number(std::uint64_t{chunk_.size()});
    index.end();
    ++chunks_;
    all_times_.take(times_.first);
    all_times_.take(times_.last);
    for (KnownChannel& channel : known_) channel.messages += channel.index.size();
  }

  void write_summary(McapRecords& records) {
    struct Group {
      McapOp op;
      std::size_t start;
      std::size_t length;
    };
    std::vector<Group> groups;
    const auto group = [&](McapOp op, const auto& write) {
      const std::size_t start = piece_.size();
      write();
      if (piece_.size() > start) groups.push_back({op, start, piece_.size() - start});
    };
    group(McapOp::schema, [&] { records.raw(schemas_); });
    group(McapOp::channel, [&] { records.raw(channels_); });
    group(McapOp::statistics, [&] { write_statistics(records); });
    group(McapOp::chunk_index, [&] { records.raw(chunk_indexes_); });
    summary_offsets_ = piece_.size();
    for (const Group& g : groups) {
      records.begin(McapOp::summary_offset);
      records.number(static_cast<std::uint8_t>(g.op));
      records.number(file_.size() + g.start);
      records.number(std::uint64_t{g.length});
      records.end();
    }
  }

  void write_statistics(McapRecords& records) const {
    std::uint64_t messages = 0;
    for (const KnownChannel& channel : known_) messages += channel.messages;
    records.begin(McapOp::statistics);
    records.number(messages);
    records.number(static_cast<std::uint16_t>(schema_ids_.size()));
    records.number(static_cast<std::uint32_t>(known_.size()));
    records.number(std::uint32_t{0});  // attachments
    records.number(std::uint32_t{0});  // metadata
    records.number(chunks_);
    put_time(records, all_times_.first);
    put_time(records, all_times_.last);
    records.begin_list();
    for (std::size_t i = 0; i < known_.size(); ++i) {
      records.number(static_cast<std::uint16_t>(i + 1));
      records.number(known_[i].messages);
    }
    records.end_list();
    records.end();
  }

  std::filesystem::path folder_;
  AppendFile file_;
  ZstdPacker packer_;
  std::map<std::string, std::uint16_t> schema_ids_;
  std::vector<KnownChannel> known_;
  Bytes chunk_;  ///< records at hand
  Times times_;
  Bytes piece_;
  Bytes packed_;
  // For the summary.
  Bytes schemas_;
  Bytes channels_;
  Bytes chunk_indexes_;
  std::uint32_t chunks_ = 0;
  Times all_times_;
  std::size_t summary_offsets_ = 0;
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
