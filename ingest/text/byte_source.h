#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

namespace slackwater::ingest {

/// The bytes of a text file, one block after the other in constant memory; of a file that
/// Zstandard packed (`.zst`, by its first bytes) those that it holds.
class ByteSource {
 public:
  /// @throws Error(not_found) where the file cannot be opened; Error(invalid_input) for one that is
  ///         packed in another way, with the command that unpacks it
  explicit ByteSource(const std::filesystem::path& file);
  ~ByteSource();
  ByteSource(const ByteSource&) = delete;
  ByteSource& operator=(const ByteSource&) = delete;

  /// Puts the next bytes into `block`; none at the end.
  /// @throws Error(invalid_input) where a packed file is damaged or ends early
  void next(std::string& block);

  [[nodiscard]] bool is_packed() const noexcept;
  /// The next bytes are those from here on, and none from `end` on. Of a file that is not packed.
  void go_to(std::uint64_t offset, std::uint64_t end);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace slackwater::ingest
