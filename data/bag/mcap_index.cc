#include "data/bag/mcap_index.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "data/bag/chunk_codec.h"
#include "data/bag/crc32.h"
#include "data/bag/quality_yaml.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

/// Loose messages are read by so many bytes at a time.
constexpr std::uint64_t loose_stretch = std::uint64_t{1} << 20U;

[[noreturn]] void damaged(const std::string& what) { throw Error(ErrorKind::invalid_input, what); }

struct Schema {
  std::string name;
  std::string definition;  ///< empty unless it is "ros2msg"
};

/// Collects schemas and channels as they come. Those that come twice must be the same, byte by
/// byte.
class Definitions {
 public:
  explicit Definitions(ChannelTable& table) : table_(&table) {}

  void take_schema(ByteView content) {
    McapFields fields(content);
    const auto id = fields.number<std::uint16_t>();
    Schema schema{fields.text(), {}};
    const std::string encoding = fields.text();
    const ByteView data = fields.raw(fields.number<std::uint32_t>());
    if (encoding == "ros2msg") schema.definition.assign(data.begin(), data.end());
    if (id != 0) schemas_.try_emplace(id, std::move(schema));
  }

  void take_channel(ByteView content) {
    McapFields fields(content);
    const auto id = fields.number<std::uint16_t>();
    const auto schema = schemas_.find(fields.number<std::uint16_t>());
    Channel channel;
    channel.topic = fields.text();
    const std::string encoding = fields.text();
    if (const std::size_t* known = table_->find(id)) {
      if (table_->channels()[*known].topic == channel.topic) return;
      damaged("channel " + std::to_string(id) + " is defined twice");
    }
    if (!not_cdr_ && encoding != "cdr") not_cdr_ = {channel.topic, encoding};
    if (schema != schemas_.end()) {
      channel.type = schema->second.name;
      channel.definition = schema->second.definition;
    }
    McapFields metadata(fields.raw(fields.number<std::uint32_t>()));
    while (metadata.left() > 0) {
      const std::string key = metadata.text();
      const std::string value = metadata.text();
      if (key == "offered_qos_profiles") channel.quality = quality_of(value);
    }
    table_->name(id, table_->add(channel));
  }

  void expect_all_cdr() const {
    if (not_cdr_) expect_cdr(not_cdr_->first, not_cdr_->second);
  }

 private:
  ChannelTable* table_;
  std::map<std::uint16_t, Schema> schemas_;
  std::optional<std::pair<std::string, std::string>> not_cdr_;  ///< topic and encoding
};

/// What the summary knows of a chunk.
struct IndexedChunk {
  McapStretch stretch;
  std::uint64_t end = 0;  ///< of it and its message indexes
};

struct Summary {
  std::uint64_t start = 0;
  std::vector<IndexedChunk> chunks;  ///< as they lie in the file
};

IndexedChunk indexed_chunk(ByteView content, std::uint64_t data_start, std::uint64_t data_end) {
  McapFields fields(content);
  IndexedChunk chunk;
  chunk.stretch.is_chunk = true;
  chunk.stretch.first_ns = fields.time_ns();
  fields.time_ns();
  chunk.stretch.offset = fields.number<std::uint64_t>();
  chunk.stretch.length = fields.number<std::uint64_t>();
  static_cast<void>(fields.raw(fields.number<std::uint32_t>()));
  const auto indexes = fields.number<std::uint64_t>();
  const bool fits = chunk.stretch.offset >= data_start && chunk.stretch.offset <= data_end &&
                    chunk.stretch.length >= mcap_record_head &&
                    chunk.stretch.length <= data_end - chunk.stretch.offset &&
                    indexes <= data_end - chunk.stretch.offset - chunk.stretch.length;
  if (!fits) damaged("the summary places a chunk outside the data");
  chunk.end = chunk.stretch.offset + chunk.stretch.length + indexes;
  return chunk;
}

class Indexer {
 public:
  explicit Indexer(const InputFile& file) : file_(file), window_(file) {}

  McapIndex index() {
    if (!file_.has(0, mcap_magic.size()) ||
        !std::equal(mcap_magic.begin(), mcap_magic.end(), window_.at(0, mcap_magic.size()).begin()))
      damaged("no MCAP file: it does not begin as one");
    std::optional<Summary> summary;
    try {
      summary = read_summary();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::invalid_input) throw;
      warn("the summary is damaged (" + error.message() + "): all of the file is read instead");
      index_ = McapIndex{{}, {}, index_.warnings};
      definitions_ = Definitions(index_.channels);
    }
    try {
      walk(summary);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::invalid_input) throw;
      warn("cut short or damaged at byte " + std::to_string(at_) + " of " +
           std::to_string(file_.size()) + " (" + error.message() +
           "): what stands before it is read");
    }
    end_loose();
    definitions_.expect_all_cdr();
    return std::move(index_);
  }

 private:
  void warn(const std::string& what) {
    index_.warnings.push_back(file_.path().string() + ": " + what);
  }

  /// Nothing where the file has none that could be used.
  std::optional<Summary> read_summary() {
    constexpr std::uint64_t tail = mcap_record_head + mcap_footer + mcap_magic.size();
    if (!file_.has(mcap_magic.size(), tail)) return std::nullopt;
    const std::uint64_t footer = file_.size() - tail;
    ByteView bytes = window_.at(footer, tail).first(tail);
    if (!std::equal(mcap_magic.begin(), mcap_magic.end(), bytes.last(mcap_magic.size()).begin()) ||
        bytes[0] != static_cast<std::uint8_t>(McapOp::footer))
      return std::nullopt;  // cut short, as `walk` will tell
    McapFields fields(bytes.subspan(mcap_record_head, mcap_footer));
    Summary summary;
    summary.start = fields.number<std::uint64_t>();
    static_cast<void>(fields.number<std::uint64_t>());
    const auto sum = fields.number<std::uint32_t>();
    if (summary.start == 0) return std::nullopt;
    if (summary.start < mcap_magic.size() || summary.start > footer)
      damaged("it is said to begin outside the file");
    if (footer - summary.start > largest_chunk) return std::nullopt;
    Bytes all;
    file_.read(summary.start, file_.size() - summary.start, all);
    if (sum != 0 && sum != crc32(ByteView(all).first(all.size() - mcap_magic.size() - 4)))
      damaged("its sum is another");
    take_summary(ByteView(all).first(static_cast<std::size_t>(footer - summary.start)), summary);
    // Channels may stand in the chunks alone: then all of them are to be looked through.
    if (!has_channels_) return std::nullopt;
    return summary;
  }

  void take_summary(ByteView bytes, Summary& summary) {
    // Channels need their schemas, which may come later.
    for (ByteView rest = bytes; !rest.empty();) {
      const McapRecord record = take_record(rest);
      if (record.op == McapOp::schema) definitions_.take_schema(record.content);
    }
    for (ByteView rest = bytes; !rest.empty();) {
      const McapRecord record = take_record(rest);
      if (record.op == McapOp::channel) {
        definitions_.take_channel(record.content);
        has_channels_ = true;
      } else if (record.op == McapOp::chunk_index) {
        summary.chunks.push_back(indexed_chunk(record.content, mcap_magic.size(), summary.start));
      }
    }
    std::sort(summary.chunks.begin(), summary.chunks.end(),
              [](const IndexedChunk& a, const IndexedChunk& b) {
                return a.stretch.offset < b.stretch.offset;
              });
    for (std::size_t i = 1; i < summary.chunks.size(); ++i) {
      if (summary.chunks[i].stretch.offset < summary.chunks[i - 1].end)
        damaged("it places two chunks at one place");
    }
  }

  /// Goes through the data record by record; over what the summary has told it leaps.
  void walk(const std::optional<Summary>& summary) {
    at_ = mcap_magic.size();
    std::size_t next_chunk = 0;
    for (;;) {
      if (summary && next_chunk < summary->chunks.size() &&
          at_ == summary->chunks[next_chunk].stretch.offset) {
        end_loose();
        index_.stretches.push_back(summary->chunks[next_chunk].stretch);
        at_ = summary->chunks[next_chunk].end;
        ++next_chunk;
        continue;
      }
      if (!file_.has(at_, mcap_record_head)) damaged("it ends without an end");
      McapFields head(window_.at(at_, mcap_record_head));
      const auto op = static_cast<McapOp>(head.number<std::uint8_t>());
      const auto length = head.number<std::uint64_t>();
      if (!file_.has(at_ + mcap_record_head, length)) damaged("a record goes beyond the end");
      if (op == McapOp::data_end || op == McapOp::footer) break;
      take(op, length);
      at_ += mcap_record_head + length;
    }
    if (summary && next_chunk < summary->chunks.size())
      damaged("the data end before all chunks of the summary were met");
  }

  void take(McapOp op, std::uint64_t length) {
    const std::uint64_t content = at_ + mcap_record_head;
    switch (op) {
      case McapOp::none:
        damaged("there is no record of kind 0");
      case McapOp::schema:
      case McapOp::channel:
        if (length > largest_chunk) damaged("a definition of " + std::to_string(length) + " bytes");
        file_.read(content, length, work_);
        op == McapOp::schema ? definitions_.take_schema(work_) : definitions_.take_channel(work_);
        break;
      case McapOp::message: {
        if (length < mcap_message_head)
          damaged("a message of " + std::to_string(length) + " bytes");
        McapFields fields(window_.at(content, mcap_message_head));
        take_loose(time_of_message(fields), mcap_record_head + length);
        break;
      }
      case McapOp::chunk:
        end_loose();
        take_chunk(mcap_record_head + length);
        break;
      default:
        break;  // nothing that is needed
    }
  }

  std::int64_t time_of_message(McapFields& fields) const {
    const auto channel = fields.number<std::uint16_t>();
    if (index_.channels.find(channel) == nullptr)
      damaged("a message of channel " + std::to_string(channel) + ", which is not defined");
    static_cast<void>(fields.number<std::uint32_t>());
    return fields.time_ns();
  }

  void take_loose(std::int64_t time_ns, std::uint64_t length) {
    if (loose_ && at_ + length - loose_->offset > loose_stretch) end_loose();
    if (length > largest_chunk) damaged("a message of " + std::to_string(length) + " bytes");
    if (!loose_) loose_ = McapStretch{at_, 0, time_ns, false};
    loose_->length = at_ + length - loose_->offset;
    loose_->first_ns = std::min(loose_->first_ns, time_ns);
  }

  void end_loose() {
    if (loose_) index_.stretches.push_back(*loose_);
    loose_.reset();
  }

  /// A chunk that no summary tells of is unpacked for what it defines, and for its times.
  void take_chunk(std::uint64_t length) {
    McapStretch chunk{at_, length, std::numeric_limits<std::int64_t>::max(), true};
    read_stretch(file_, chunk, work_, records_);
    bool has_messages = false;
    for (ByteView rest = records_; !rest.empty();) {
      const McapRecord record = take_record(rest);
      if (record.op == McapOp::schema) definitions_.take_schema(record.content);
      if (record.op == McapOp::channel) definitions_.take_channel(record.content);
      if (record.op != McapOp::message) continue;
      McapFields fields(record.content);
      chunk.first_ns = std::min(chunk.first_ns, time_of_message(fields));
      has_messages = true;
    }
    if (has_messages) index_.stretches.push_back(chunk);
  }

  const InputFile& file_;
  InputWindow window_;
  McapIndex index_;
  Definitions definitions_{index_.channels};
  bool has_channels_ = false;
  std::uint64_t at_ = 0;
  std::optional<McapStretch> loose_;
  Bytes work_;
  Bytes records_;
};

}  // namespace

McapIndex index_of(const InputFile& file) { return Indexer(file).index(); }

void read_stretch(const InputFile& file, const McapStretch& stretch, Bytes& file_bytes,
                  Bytes& records) {
  if (stretch.length > largest_chunk) {
    damaged("a chunk of " + std::to_string(stretch.length) + " bytes; no more than " +
            std::to_string(largest_chunk) + " are read");
  }
  if (!stretch.is_chunk) {
    file.read(stretch.offset, stretch.length, records);
    return;
  }
  file.read(stretch.offset, stretch.length, file_bytes);
  ByteView rest = file_bytes;
  const McapRecord record = take_record(rest);
  if (record.op != McapOp::chunk || !rest.empty()) damaged("no chunk where one is said to be");
  McapFields fields(record.content);
  fields.time_ns();
  fields.time_ns();
  const auto size = fields.number<std::uint64_t>();
  const auto sum = fields.number<std::uint32_t>();
  const std::string compression = fields.text();
  const ByteView packed = fields.raw(fields.number<std::uint64_t>());
  unpack_chunk(compression, packed, size, records);
  if (sum != 0 && sum != crc32(records)) damaged("the sum of a chunk is another");
}

}  // namespace slackwater::bag
