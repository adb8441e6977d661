#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>

namespace slackwater {

/// SHA-256 (FIPS 180-4) of bytes fed piece by piece; the name under which the store knows a file.
class Sha256 {
 public:
  Sha256();
  ~Sha256();
  Sha256(Sha256&&) noexcept;
  Sha256& operator=(Sha256&&) noexcept;

  void update(std::span<const std::byte> bytes);
  void update(std::string_view text);
  /// 64 lower-case hexadecimal digits. Call once.
  [[nodiscard]] std::string hex();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Hash of a whole file, read in pieces of 1 MiB; `on_bytes(n)` after each piece (may be empty).
/// Throws Error(not_found) where there is no such file, Error(unavailable) where it cannot be read.
[[nodiscard]] std::string sha256_of_file(const std::filesystem::path& file,
                                         const std::function<void(std::size_t)>& on_bytes = {});
[[nodiscard]] std::string sha256_of_text(std::string_view text);

}  // namespace slackwater
