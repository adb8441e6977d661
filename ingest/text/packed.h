#pragma once
#include <optional>
#include <string_view>

namespace slackwater::ingest {

/// How a file is packed, by its first bytes.
struct Packing {
  std::string_view name;    ///< "a zip archive"
  std::string_view unpack;  ///< the command that unpacks it: "unzip"
};

/// Nothing for what is not packed, as far as we know. Six bytes are enough.
/// Source: the formats' own descriptions (RFC 1952, RFC 8878, PKWARE's APPNOTE 4.3.7, xz 2.1.1.1,
/// 7zFormat.txt, bzip2).
[[nodiscard]] std::optional<Packing> packing_of(std::string_view first_bytes) noexcept;

/// Whether the bytes begin a Zstandard frame (RFC 8878, 3.1.1).
[[nodiscard]] bool is_zstd(std::string_view first_bytes) noexcept;

}  // namespace slackwater::ingest
