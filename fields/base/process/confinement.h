#pragma once
#include <filesystem>
#include <vector>

#include "fields/base/descriptor.h"

struct sock_filter;

namespace slackwater {

/// What files a confined process may still reach. What is not there is left out.
struct Reach {
  std::vector<std::filesystem::path> readable;  ///< files, and folders with all below them
  std::vector<std::filesystem::path> writable;  ///< folders: files are made, changed, removed below
  /// Of these programs, which may be run. Empty: none, and no memory is run as code.
  std::vector<std::filesystem::path> programs;
};

/// How far this system can confine a process.
struct ConfinementOfSystem {
  bool calls = false;  ///< system calls are filtered (seccomp)
  bool files = false;  ///< only files within reach can be opened (Landlock, since Linux 5.13)
};
[[nodiscard]] ConfinementOfSystem confinement_of_system() noexcept;

/// Takes from a process, for good, what reading a file does not need: the network, other programs
/// and processes, memory that is run as code, and all files but those within reach. What is asked
/// beyond that fails, and the process goes on.
///
/// Made beforehand, since making it allocates; `apply` may be called between fork and exec.
class Confinement {
 public:
  /// @throws Error(unavailable) where the system has no memory or descriptors left
  explicit Confinement(const Reach& reach);
  ~Confinement();
  Confinement(const Confinement&) = delete;
  Confinement& operator=(const Confinement&) = delete;

  /// Of this process and all that it begins. Where the system cannot confine files, or calls, these
  /// stay as they are. @return false: it can, and it did not work
  [[nodiscard]] bool apply() const noexcept;

 private:
  std::vector<sock_filter> calls_;
  Descriptor files_;
};

}  // namespace slackwater
