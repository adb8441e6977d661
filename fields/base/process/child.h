#pragma once
#include <sys/types.h>

#include <cstdint>

namespace slackwater {

/// A process of ours: ended and waited for, also where an exception passes by.
class Child {
 public:
  explicit Child(pid_t process) noexcept : process_(process) {}
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  [[nodiscard]] pid_t process() const noexcept { return process_; }
  /// Of memory; 0: it is over.
  [[nodiscard]] std::uint64_t bytes_in_use() const;
  /// Of one that is over: nothing.
  void end() const noexcept;
  /// Of one that has nothing more to say: it is ended where it does not end within ten seconds.
  /// @return its status, as waitpid has it
  int wait_a_while() noexcept;

 private:
  int wait() noexcept;
  pid_t process_;
};

}  // namespace slackwater
