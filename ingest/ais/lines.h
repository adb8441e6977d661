#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "ingest/text/byte_source.h"

namespace slackwater::ingest {

/// One line of a text file, without its end (LF or CR LF).
struct TextLine {
  std::size_t number = 0;    ///< from 1
  std::string_view text;     ///< until the next line is read
  bool is_too_long = false;  ///< longer than the limit: `text` holds its beginning
};

/// Reads a text file, packed by Zstandard or not, line by line in constant memory, whatever the
/// bytes are.
class Lines {
 public:
  /// Longest line kept: a tag block (80 characters) and a sentence (82) by NMEA 0183, and room for
  /// loggers.
  static constexpr std::size_t most_characters = 1024;

  /// @throws as `ByteSource`
  explicit Lines(const std::filesystem::path& file);
  [[nodiscard]] std::optional<TextLine> next();

  [[nodiscard]] bool is_packed() const noexcept { return bytes_.is_packed(); }
  /// The next line is the first that begins at this byte or behind it, and the last one ends at
  /// `end`. Lines are counted from there. Of a file that is not packed.
  void go_to(std::uint64_t offset, std::uint64_t end);

 private:
  ByteSource bytes_;
  std::string block_;
  std::size_t at_ = 0;
  std::string line_;
  std::size_t number_ = 0;
};

}  // namespace slackwater::ingest
