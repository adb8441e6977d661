#pragma once
#include <cstdint>
#include <filesystem>
#include <span>

#include "data/store/durable.h"

namespace slackwater::bag {

/// A new file that grows at its end, piece by piece: of a piece that the disk refuses nothing
/// stays. Errors are Error(unavailable) with the path and the system's own text.
class AppendFile {
 public:
  /// Error(invalid_input) where something lies at that path.
  explicit AppendFile(const std::filesystem::path& path);

  void append(std::span<const std::uint8_t> piece);
  void sync();  ///< returns once it would outlive a power cut
  [[nodiscard]] std::uint64_t size() const noexcept { return size_; }

 private:
  [[noreturn]] void fail(int system_errno) const;

  std::filesystem::path path_;
  Descriptor file_;
  std::uint64_t size_ = 0;
};

/// What is said of a path where something lies already.
[[noreturn]] void refuse_existing(const std::filesystem::path& path);

}  // namespace slackwater::bag
