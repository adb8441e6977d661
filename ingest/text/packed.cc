#include "ingest/text/packed.h"

#include <array>

namespace slackwater::ingest {
namespace {

struct Magic {
  std::string_view bytes;
  Packing packing;
};
constexpr std::array magics{
    Magic{"PK\x03\x04", {"a zip archive", "unzip"}},
    Magic{"\x1f\x8b", {"a gzip file", "gunzip"}},
    Magic{"\x28\xb5\x2f\xfd", {"a Zstandard file", "zstd -d"}},
    Magic{"BZh", {"a bzip2 file", "bunzip2"}},
    Magic{{"\xfd"
           "7zXZ",
           5},
          {"an xz file", "unxz"}},
    Magic{"7z\xbc\xaf\x27\x1c", {"a 7z archive", "7z x"}},
};

}  // namespace

std::optional<Packing> packing_of(std::string_view first_bytes) noexcept {
  for (const Magic& magic : magics) {
    if (first_bytes.starts_with(magic.bytes)) return magic.packing;
  }
  return std::nullopt;
}

bool is_zstd(std::string_view first_bytes) noexcept {
  return first_bytes.starts_with("\x28\xb5\x2f\xfd");
}

}  // namespace slackwater::ingest
