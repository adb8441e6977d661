#pragma once
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace slackwater::store::tests {

/// A slackwater_store_worker in its own process. Killed and reaped with its owner.
class WorkerProcess {
 public:
  WorkerProcess(const std::filesystem::path& store, const std::vector<std::string>& steps,
                const std::map<std::string, std::string>& environment = {});
  ~WorkerProcess();
  WorkerProcess(const WorkerProcess&) = delete;
  WorkerProcess& operator=(const WorkerProcess&) = delete;

  void kill() const;
  /// All complete lines it said, once it has ended.
  [[nodiscard]] std::vector<std::string> finish();
  /// Its exit code, or minus the signal that ended it; after `finish`.
  [[nodiscard]] int exit_code() const noexcept { return exit_code_; }
  /// Waits until it has said this line; false if it ended before.
  bool wait_for(const std::string& line);

 private:
  bool read_more();
  pid_t pid_ = -1;
  int pipe_ = -1;
  std::string said_;
  int exit_code_ = 0;
};

/// The environment under which calls below `root` are recorded in `log` and the `at`-th one (0:
/// none) fails.
[[nodiscard]] std::map<std::string, std::string> fault_environment(
    const std::filesystem::path& root, const std::filesystem::path& log, long at = 0, int error = 0,
    bool sticky = false);

[[nodiscard]] bool has_line(const std::vector<std::string>& lines, const std::string& line);

}  // namespace slackwater::store::tests
