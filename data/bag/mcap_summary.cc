#include "data/bag/mcap_summary.h"

#include <algorithm>
#include <string>

#include "data/bag/chunk_codec.h"
#include "data/bag/crc32.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

McapSummary::Chunk indexed_chunk(ByteView content, std::uint64_t data_start,
                                 std::uint64_t data_end) {
  McapFields fields(content);
  McapSummary::Chunk chunk;
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
  if (!fits) refuse("the summary places a chunk outside the data");
  chunk.end = chunk.stretch.offset + chunk.stretch.length + indexes;
  return chunk;
}

McapSummary summary_in(ByteView bytes, std::uint64_t data_end, McapDefinitions& definitions) {
  McapSummary summary;
  // Channels need their schemas, which may come later.
  for (ByteView rest = bytes; !rest.empty();) {
    const McapRecord record = take_record(rest);
    if (record.op == McapOp::schema) definitions.take_schema(record.content);
  }
  for (ByteView rest = bytes; !rest.empty();) {
    const McapRecord record = take_record(rest);
    if (record.op == McapOp::channel) {
      definitions.take_channel(record.content);
    } else if (record.op == McapOp::chunk_index) {
      summary.chunks.push_back(indexed_chunk(record.content, mcap_magic.size(), data_end));
    }
  }
  std::sort(summary.chunks.begin(), summary.chunks.end(),
            [](const McapSummary::Chunk& a, const McapSummary::Chunk& b) {
              return a.stretch.offset < b.stretch.offset;
            });
  for (std::size_t i = 1; i < summary.chunks.size(); ++i) {
    if (summary.chunks[i].stretch.offset < summary.chunks[i - 1].end)
      refuse("it places two chunks at one place");
  }
  return summary;
}

}  // namespace

std::optional<McapSummary> read_summary(const InputFile& file, McapDefinitions& definitions) {
  constexpr std::uint64_t tail = mcap_record_head + mcap_footer + mcap_magic.size();
  if (!file.has(mcap_magic.size(), tail)) return std::nullopt;
  const std::uint64_t footer = file.size() - tail;
  Bytes all;
  file.read(footer, tail, all);
  const ByteView bytes = all;
  if (!std::equal(mcap_magic.begin(), mcap_magic.end(), bytes.last(mcap_magic.size()).begin()) ||
      bytes[0] != static_cast<std::uint8_t>(McapOp::footer))
    return std::nullopt;  // cut short, as reading on will tell
  McapFields fields(bytes.subspan(mcap_record_head, mcap_footer));
  const auto start = fields.number<std::uint64_t>();
  static_cast<void>(fields.number<std::uint64_t>());
  const auto sum = fields.number<std::uint32_t>();
  if (start == 0) return std::nullopt;
  if (start < mcap_magic.size() || start > footer) refuse("it is said to begin outside the file");
  if (footer - start > largest_chunk) return std::nullopt;
  file.read(start, file.size() - start, all);
  if (sum != 0 && sum != crc32(ByteView(all).first(all.size() - mcap_magic.size() - 4)))
    refuse("its sum is another");
  McapSummary summary =
      summary_in(ByteView(all).first(static_cast<std::size_t>(footer - start)), start, definitions);
  // Channels may stand in the chunks alone: then all of them are to be looked through.
  if (definitions.channels().channels().empty()) return std::nullopt;
  return summary;
}

}  // namespace slackwater::bag
