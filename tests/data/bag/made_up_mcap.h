#pragma once
#include <fstream>
#include <initializer_list>

#include "data/bag/crc32.h"
#include "data/bag/mcap_record.h"
#include "tests/data/bag/samples.h"

namespace slackwater::bag::tests {

/// MCAP files as others may write them, put together record by record.
class MadeUpMcap {
 public:
  MadeUpMcap() {
    bytes.assign(mcap_magic.begin(), mcap_magic.end());
    records.begin(McapOp::header);
    records.text("ros2");
    records.text("made up");
    records.end();
  }

  MadeUpMcap(const MadeUpMcap&) = delete;
  MadeUpMcap& operator=(const MadeUpMcap&) = delete;

  void schema(std::uint16_t id, const Channel& channel, const std::string& encoding = "ros2msg") {
    records.begin(McapOp::schema);
    records.number(id);
    records.text(channel.type);
    records.text(encoding);
    records.text(channel.definition);
    records.end();
  }
  void channel(std::uint16_t id, std::uint16_t schema_id, const std::string& topic,
               const std::string& encoding = "cdr") {
    records.begin(McapOp::channel);
    records.number(id);
    records.number(schema_id);
    records.text(topic);
    records.text(encoding);
    records.begin_list();
    records.end_list();
    records.end();
  }
  void message(std::uint16_t channel_id, std::uint64_t time_ns, ByteView payload) {
    records.begin(McapOp::message);
    records.number(channel_id);
    records.number(std::uint32_t{0});
    records.number(time_ns);
    records.number(time_ns);
    records.raw(payload);
    records.end();
  }
  /// A chunk of the records that stand in `inside`, packed as it comes.
  void chunk(const MadeUpMcap& inside, const std::string& compression, ByteView packed,
             std::uint64_t size) {
    const std::size_t start = bytes.size();
    records.begin(McapOp::chunk);
    records.number(std::uint64_t{0});
    records.number(std::uint64_t{0});
    records.number(size);
    records.number(crc32(inside.content()));
    records.text(compression);
    records.number(std::uint64_t{packed.size()});
    records.raw(packed);
    records.end();
    chunks.push_back({start, bytes.size() - start});
  }
  void chunk(const MadeUpMcap& inside) {
    chunk(inside, "", inside.content(), inside.content().size());
  }
  /// The end, with or without a summary of the channels given and all chunks.
  void end(const MadeUpMcap* definitions, std::uint64_t first_ns = 0) {
    records.begin(McapOp::data_end);
    records.number(std::uint32_t{0});
    records.end();
    const std::size_t summary = bytes.size();
    if (definitions != nullptr) {
      records.raw(definitions->content());
      for (const Place& place : chunks) {
        records.begin(McapOp::chunk_index);
        records.number(first_ns);
        records.number(first_ns);
        records.number(std::uint64_t{place.offset});
        records.number(std::uint64_t{place.length});
        records.number(std::uint32_t{0});
        records.number(std::uint64_t{0});
        records.text("");
        records.number(std::uint64_t{0});
        records.number(std::uint64_t{0});
        records.end();
      }
    }
    records.begin(McapOp::footer);
    records.number(std::uint64_t{definitions != nullptr ? summary : 0});
    records.number(std::uint64_t{0});
    records.number(std::uint32_t{0});
    records.end();
    records.raw(mcap_magic);
  }

  /// Without the magic and the header.
  [[nodiscard]] ByteView content() const { return ByteView(bytes).subspan(8 + 9 + 4 + 4 + 4 + 7); }

  struct Place {
    std::size_t offset;
    std::size_t length;
  };
  Bytes bytes;
  McapRecords records{bytes};
  std::vector<Place> chunks;
};

inline std::filesystem::path write_file(const std::filesystem::path& path, ByteView bytes) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  return path;
}

inline Bytes bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace slackwater::bag::tests
