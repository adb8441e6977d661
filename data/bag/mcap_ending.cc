#include "data/bag/mcap_ending.h"

#include <algorithm>
#include <numeric>

#include "data/bag/crc32.h"

namespace slackwater::bag {
namespace {

void put_times(McapRecords& records, const McapTimes& times) {
  records.number(static_cast<std::uint64_t>(times.first_ns));
  records.number(static_cast<std::uint64_t>(times.last_ns));
}

}  // namespace

void McapTimes::take(std::int64_t time_ns) noexcept {
  first_ns = is_empty ? time_ns : std::min(first_ns, time_ns);
  last_ns = is_empty ? time_ns : std::max(last_ns, time_ns);
  is_empty = false;
}

void McapEnding::take_schema(ByteView record) {
  schemas_.insert(schemas_.end(), record.begin(), record.end());
  ++schema_count_;
}

void McapEnding::take_channel(ByteView record) {
  channels_.insert(channels_.end(), record.begin(), record.end());
  counts_.push_back(0);
}

void McapEnding::take_chunk(const McapChunk& chunk) {
  McapRecords records(chunk_indexes_);
  records.begin(McapOp::chunk_index);
  put_times(records, chunk.times);
  records.number(chunk.offset);
  records.number(chunk.length);
  records.number(static_cast<std::uint32_t>(chunk.index_offsets.size()));
  records.raw(chunk.index_offsets);
  records.number(chunk.indexes_length);
  records.text("zstd");
  records.number(chunk.packed);
  records.number(chunk.unpacked);
  records.end();
  ++chunk_count_;
  times_.take(chunk.times.first_ns);
  times_.take(chunk.times.last_ns);
}

void McapEnding::write(std::uint64_t offset, Bytes& out) const {
  struct Group {
    McapOp op;
    std::size_t start;
    std::size_t length;
  };
  const std::size_t before = out.size();
  const auto in_file = [&](std::size_t at) -> std::uint64_t { return offset + at - before; };
  McapRecords records(out);
  records.begin(McapOp::data_end);
  records.number(std::uint32_t{0});  // no sum of the whole: each chunk has its own
  records.end();

  const std::size_t summary = out.size();
  std::vector<Group> groups;
  const auto group = [&](McapOp op, const auto& write_group) {
    const std::size_t start = out.size();
    write_group();
    if (out.size() > start) groups.push_back({op, start, out.size() - start});
  };
  group(McapOp::schema, [&] { records.raw(schemas_); });
  group(McapOp::channel, [&] { records.raw(channels_); });
  group(McapOp::statistics, [&] { write_statistics(records); });
  group(McapOp::chunk_index, [&] { records.raw(chunk_indexes_); });
  const std::size_t summary_offsets = out.size();
  for (const Group& g : groups) {
    records.begin(McapOp::summary_offset);
    records.number(static_cast<std::uint8_t>(g.op));
    records.number(in_file(g.start));
    records.number(std::uint64_t{g.length});
    records.end();
  }

  records.begin(McapOp::footer);
  records.number(in_file(summary));
  records.number(in_file(summary_offsets));
  records.number(std::uint32_t{0});
  records.end();
  // The sum is of all that stands between the summary's first byte and the sum itself.
  out.resize(out.size() - 4);
  records.number(crc32(ByteView(out).subspan(summary)));
  records.raw(mcap_magic);
}

void McapEnding::write_statistics(McapRecords& records) const {
  records.begin(McapOp::statistics);
  records.number(std::accumulate(counts_.begin(), counts_.end(), std::uint64_t{0}));
  records.number(schema_count_);
  records.number(static_cast<std::uint32_t>(counts_.size()));
  records.number(std::uint32_t{0});  // attachments
  records.number(std::uint32_t{0});  // metadata
  records.number(chunk_count_);
  put_times(records, times_);
  records.begin_list();
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    records.number(static_cast<std::uint16_t>(i + 1));
    records.number(counts_[i]);
  }
  records.end_list();
  records.end();
}

}  // namespace slackwater::bag
