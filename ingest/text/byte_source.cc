#include "ingest/text/byte_source.h"

#include <zstd.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <utility>

#include "fields/base/check.h"
#include "fields/base/error.h"
#include "fields/base/given_file.h"
#include "ingest/text/packed.h"

namespace slackwater::ingest {
namespace {

constexpr std::size_t block_bytes = 65536;

struct FreeStream {
  void operator()(ZSTD_DStream* stream) const { ZSTD_freeDStream(stream); }
};

}  // namespace

struct ByteSource::State {
  std::ifstream file;
  std::unique_ptr<ZSTD_DStream, FreeStream> unpacker{};  ///< null: the file is not packed
  std::string packed{};
  std::size_t at = 0;         ///< of `packed`
  bool frame_is_open = true;  ///< the frame that is unpacked has not ended
  std::uint64_t to_read = std::numeric_limits<std::uint64_t>::max();  ///< of the file's bytes

  /// Up to a block of the file's own bytes.
  void read(std::string& block) {
    block.resize(static_cast<std::size_t>(std::min<std::uint64_t>(block_bytes, to_read)));
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    block.resize(static_cast<std::size_t>(file.gcount()));
    to_read -= block.size();
  }

  void unpack(std::string& block) {
    block.resize(block_bytes);
    ZSTD_outBuffer out{block.data(), block.size(), 0};
    while (out.pos == 0) {
      if (at == packed.size()) {
        read(packed);
        at = 0;
      }
      const bool at_end = packed.empty();
      if (at_end && !frame_is_open) break;
      // At the end too: what was unpacked and found no room in the last block.
      ZSTD_inBuffer in{packed.data(), packed.size(), at};
      const std::size_t left = ZSTD_decompressStream(unpacker.get(), &out, &in);
      if (ZSTD_isError(left) != 0)
        refuse(std::string("the Zstandard file is damaged (") + ZSTD_getErrorName(left) +
               "); download it again");
      if (at_end && out.pos == 0)
        refuse("the Zstandard file ends early, it is not whole; download it again");
      at = in.pos;
      frame_is_open = left != 0;
    }
    block.resize(out.pos);
  }
};

ByteSource::ByteSource(const std::filesystem::path& file) : state_(std::make_unique<State>()) {
  expect_given_file(file, "a file");
  state_->file.open(file, std::ios::binary);
  std::string first(6, '\0');
  state_->file.read(first.data(), static_cast<std::streamsize>(first.size()));
  first.resize(static_cast<std::size_t>(state_->file.gcount()));
  state_->file.clear();
  state_->file.seekg(0);
  if (is_zstd(first)) {
    state_->unpacker.reset(ZSTD_createDStream());
    if (!state_->unpacker) throw Error(ErrorKind::unavailable, "found no memory to unpack with");
  } else if (const auto packing = packing_of(first)) {
    refuse("found " + std::string(packing->name) + ", expected the text in it; unpack it with `" +
           std::string(packing->unpack) + "`");
  }
}

ByteSource::~ByteSource() = default;

void ByteSource::next(std::string& block) {
  if (state_->unpacker) {
    state_->unpack(block);
  } else {
    state_->read(block);
  }
}

bool ByteSource::is_packed() const noexcept { return state_->unpacker != nullptr; }

void ByteSource::go_to(std::uint64_t offset, std::uint64_t end) {
  expects(!is_packed(), "a place in a file that is not packed");
  state_->file.clear();
  state_->file.seekg(static_cast<std::streamoff>(offset));
  state_->to_read = end > offset ? end - offset : 0;
}

}  // namespace slackwater::ingest
