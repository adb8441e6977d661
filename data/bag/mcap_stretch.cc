#include "data/bag/mcap_stretch.h"

#include <string>

#include "data/bag/chunk_codec.h"
#include "data/bag/crc32.h"
#include "fields/base/error.h"

namespace slackwater::bag {
namespace {}  // namespace

void read_stretch(const InputFile& file, const McapStretch& stretch, Bytes& file_bytes,
                  Bytes& records) {
  if (stretch.length > largest_chunk) {
    refuse("a chunk of " + std::to_string(stretch.length) + " bytes; no more than " +
           std::to_string(largest_chunk) + " are read");
  }
  if (!stretch.is_chunk) {
    file.read(stretch.offset, stretch.length, records);
    return;
  }
  file.read(stretch.offset, stretch.length, file_bytes);
  ByteView rest = file_bytes;
  const McapRecord record = take_record(rest);
  if (record.op != McapOp::chunk || !rest.empty()) refuse("no chunk where one is said to be");
  McapFields fields(record.content);
  fields.time_ns();
  fields.time_ns();
  const auto size = fields.number<std::uint64_t>();
  const auto sum = fields.number<std::uint32_t>();
  const std::string compression = fields.text();
  const ByteView packed = fields.raw(fields.number<std::uint64_t>());
  unpack_chunk(compression, packed, size, records);
  if (sum != 0 && sum != crc32(records)) refuse("the sum of a chunk is another");
}

}  // namespace slackwater::bag
