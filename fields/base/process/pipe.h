#pragma once
#include <array>

namespace slackwater {

/// A pipe between this process and another. Its ends are closed with it, and not handed on to
/// programs that are started.
class Pipe {
 public:
  /// @throws Error(unavailable) where the system has none left
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  /// The descriptors; -1: closed.
  [[nodiscard]] int reading() const noexcept { return ends_[0]; }
  [[nodiscard]] int writing() const noexcept { return ends_[1]; }
  void close_reading() noexcept { close(0); }
  void close_writing() noexcept { close(1); }

 private:
  void close(std::size_t end) noexcept;
  std::array<int, 2> ends_{-1, -1};
};

}  // namespace slackwater
