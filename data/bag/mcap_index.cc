#include "data/bag/mcap_index.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "data/bag/chunk_codec.h"
#include "data/bag/mcap_definitions.h"
#include "data/bag/mcap_summary.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

/// Loose messages are read by so many bytes at a time.
constexpr std::uint64_t loose_stretch = std::uint64_t{1} << 20U;

class Indexer {
 public:
  explicit Indexer(const InputFile& file) : file_(file), window_(file) {}

  McapIndex index() {
    if (!file_.has(0, mcap_magic.size()) ||
        !std::equal(mcap_magic.begin(), mcap_magic.end(), window_.at(0, mcap_magic.size()).begin()))
      refuse("no MCAP file: it does not begin as one");
    std::optional<McapSummary> summary;
    try {
      summary = read_summary(file_, definitions_);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::invalid_input) throw;
      warn("the summary is damaged (" + error.message() + "): all of the file is read instead");
      definitions_ = {};
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
    index_.channels = definitions_.channels();
    return std::move(index_);
  }

 private:
  void warn(const std::string& what) {
    index_.warnings.push_back(file_.path().string() + ": " + what);
  }

  /// Goes through the data record by record; over what the summary has told it leaps.
  void walk(const std::optional<McapSummary>& summary) {
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
      if (!file_.has(at_, mcap_record_head)) refuse("it ends without an end");
      McapFields head(window_.at(at_, mcap_record_head));
      const auto op = static_cast<McapOp>(head.number<std::uint8_t>());
      const auto length = head.number<std::uint64_t>();
      if (!file_.has(at_ + mcap_record_head, length)) refuse("a record goes beyond the end");
      if (op == McapOp::data_end || op == McapOp::footer) break;
      take(op, length);
      at_ += mcap_record_head + length;
    }
    if (summary && next_chunk < summary->chunks.size())
      refuse("the data end before all chunks of the summary were met");
  }

  void take(McapOp op, std::uint64_t length) {
    const std::uint64_t content = at_ + mcap_record_head;
    switch (op) {
      case McapOp::none:
        refuse("there is no record of kind 0");
      case McapOp::schema:
      case McapOp::channel:
        if (length > largest_chunk) refuse("a definition of " + std::to_string(length) + " bytes");
        file_.read(content, length, work_);
        op == McapOp::schema ? definitions_.take_schema(work_) : definitions_.take_channel(work_);
        break;
      case McapOp::message: {
        if (length < mcap_message_head) refuse("a message of " + std::to_string(length) + " bytes");
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
    if (definitions_.channels().find(channel) == nullptr)
      refuse("a message of channel " + std::to_string(channel) + ", which is not defined");
    static_cast<void>(fields.number<std::uint32_t>());
    return fields.time_ns();
  }

  void take_loose(std::int64_t time_ns, std::uint64_t length) {
    if (loose_ && at_ + length - loose_->offset > loose_stretch) end_loose();
    if (length > largest_chunk) refuse("a message of " + std::to_string(length) + " bytes");
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
  McapDefinitions definitions_;
  std::uint64_t at_ = 0;
  std::optional<McapStretch> loose_;
  Bytes work_;
  Bytes records_;
};

}  // namespace

McapIndex index_of(const InputFile& file) { return Indexer(file).index(); }

}  // namespace slackwater::bag
