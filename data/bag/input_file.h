#pragma once
#include <cstdint>
#include <filesystem>

#include "data/bag/mcap_record.h"
#include "data/store/durable.h"

namespace slackwater::bag {

/// A file that is read here and there. Its size is what it was when it was opened.
class InputFile {
 public:
  /// Error(not_found), Error(unavailable).
  explicit InputFile(const std::filesystem::path& path);

  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }
  /// Whether so many bytes are there.
  [[nodiscard]] bool has(std::uint64_t offset, std::uint64_t length) const noexcept {
    return offset <= size_ && length <= size_ - offset;
  }
  /// Reads into `out`, whose memory is used again. The bytes must be there (`has`);
  /// Error(unavailable) where the disk does not give them.
  void read(std::uint64_t offset, std::uint64_t length, Bytes& out) const;

 private:
  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// Looks at a few bytes here and there, without a call of the system for each.
class InputWindow {
 public:
  explicit InputWindow(const InputFile& file) : file_(&file) {}
  /// At least `length` bytes from there, which must be there; good until the next call.
  [[nodiscard]] ByteView at(std::uint64_t offset, std::uint64_t length);

 private:
  const InputFile* file_;
  std::uint64_t start_ = 0;
  Bytes bytes_;
};

}  // namespace slackwater::bag
