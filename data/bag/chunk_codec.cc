#include "data/bag/chunk_codec.h"

#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <string>

#include "fields/base/error.h"

namespace slackwater::bag {
namespace {

constexpr int fastest_regular_level = 1;
constexpr std::size_t smallest_step = std::size_t{64} << 10U;

[[noreturn]] void damaged(const std::string& what) {
  throw Error(ErrorKind::invalid_input, "a chunk " + what);
}

/// What one call of a decompressor did.
struct Step {
  std::size_t consumed = 0;
  std::size_t produced = 0;
  bool is_frame_complete = false;
};

/// Unpacks frame after frame. `step(in, out, out_size)` never writes beyond out_size.
template <typename Decompress>
void unpack_frames(ByteView packed, std::uint64_t size, Bytes& out, const Decompress& step) {
  out.clear();
  out.resize(std::min<std::uint64_t>(size, std::max(smallest_step, 4 * packed.size())));
  std::size_t produced = 0;
  bool is_complete = false;
  while (!packed.empty() || !is_complete) {
    if (produced == out.size() && produced < size)
      out.resize(std::min<std::uint64_t>(size, 2 * out.size()));
    const Step done = step(packed, out.data() + produced, out.size() - produced);
    packed = packed.subspan(done.consumed);
    produced += done.produced;
    is_complete = done.is_frame_complete;
    if (done.consumed == 0 && done.produced == 0 && !is_complete) {
      damaged(produced == size
                  ? "unpacks to more than the " + std::to_string(size) + " bytes that it claims"
                  : "is cut short");
    }
    if (packed.empty() && is_complete) break;
  }
  if (produced != size) {
    damaged("unpacks to " + std::to_string(produced) + " bytes where it claims " +
            std::to_string(size));
  }
}

void unpack_zstd(ByteView packed, std::uint64_t size, Bytes& out) {
  struct Free {
    void operator()(ZSTD_DCtx* context) const noexcept { ZSTD_freeDCtx(context); }
  };
  const std::unique_ptr<ZSTD_DCtx, Free> context(ZSTD_createDCtx());
  if (context == nullptr) throw Error(ErrorKind::unavailable, "zstd: out of memory");
  unpack_frames(packed, size, out, [&](ByteView in, std::uint8_t* to, std::size_t room) {
    ZSTD_inBuffer from{in.data(), in.size(), 0};
    ZSTD_outBuffer into{to, room, 0};
    const std::size_t code = ZSTD_decompressStream(context.get(), &into, &from);
    if (ZSTD_isError(code) != 0)
      damaged(std::string("is damaged: zstd: ") + ZSTD_getErrorName(code));
    return Step{from.pos, into.pos, code == 0};
  });
}

void unpack_lz4(ByteView packed, std::uint64_t size, Bytes& out) {
  struct Free {
    void operator()(LZ4F_dctx* context) const noexcept { LZ4F_freeDecompressionContext(context); }
  };
  LZ4F_dctx* made = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&made, LZ4F_VERSION)) != 0)
    throw Error(ErrorKind::unavailable, "lz4: out of memory");
  const std::unique_ptr<LZ4F_dctx, Free> context(made);
  unpack_frames(packed, size, out, [&](ByteView in, std::uint8_t* to, std::size_t room) {
    std::size_t consumed = in.size();
    std::size_t produced = room;
    const std::size_t code =
        LZ4F_decompress(context.get(), to, &produced, in.data(), &consumed, nullptr);
    if (LZ4F_isError(code) != 0)
      damaged(std::string("is damaged: lz4: ") + LZ4F_getErrorName(code));
    return Step{consumed, produced, code == 0};
  });
}

}  // namespace

void unpack_chunk(std::string_view compression, ByteView packed, std::uint64_t size, Bytes& out) {
  if (size > largest_chunk) {
    damaged("claims " + std::to_string(size) + " bytes; no more than " +
            std::to_string(largest_chunk) + " are read");
  }
  if (compression.empty()) {
    if (packed.size() != size) {
      damaged("of " + std::to_string(packed.size()) + " bytes claims " + std::to_string(size));
    }
    out.assign(packed.begin(), packed.end());
  } else if (compression == "zstd") {
    unpack_zstd(packed, size, out);
  } else if (compression == "lz4") {
    unpack_lz4(packed, size, out);
  } else {
    damaged("is compressed with '" + std::string(compression.substr(0, 40)) +
            "'; zstd, lz4 and none are read");
  }
}

struct ZstdPacker::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
};

ZstdPacker::ZstdPacker() : context_(std::make_unique<Context>()) {
  if (context_->zstd == nullptr) throw Error(ErrorKind::unavailable, "zstd: out of memory");
}
ZstdPacker::~ZstdPacker() { ZSTD_freeCCtx(context_->zstd); }

void ZstdPacker::pack(ByteView bytes, Bytes& out) {
  const std::size_t before = out.size();
  out.resize(before + ZSTD_compressBound(bytes.size()));
  const std::size_t code =
      ZSTD_compressCCtx(context_->zstd, out.data() + before, out.size() - before, bytes.data(),
                        bytes.size(), fastest_regular_level);
  if (ZSTD_isError(code) != 0) {
    throw Error(ErrorKind::unavailable, std::string("zstd: ") + ZSTD_getErrorName(code));
  }
  out.resize(before + code);
}

}  // namespace slackwater::bag
