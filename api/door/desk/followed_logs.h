#pragma once
#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "api/ask/traffic/traffic_about.h"
#include "ingest/ais/gpsdecode.h"

namespace slackwater::api::desk {

struct LogFollowing {
  Duration every = std::chrono::seconds(1);  ///< from look to look
  std::uint64_t most_bytes = 64U << 20U;     ///< read at once: of more, what stands at the end
  ingest::FilterProgram decoder = ingest::gpsdecode_program();
};

/// Logs of AIS that a receiver writes while they are read, on a thread of its own: looked at now
/// and then, and what was added is read where a file's size or time has changed. One that was
/// rotated, truncated or replaced is read from its beginning; what was heard before stays known.
///
/// What is wrong with a file is a sentence, and never ends or holds up the server: one that is
/// gone, is a pipe or a device (it is opened without waiting), holds no AIS, or breaks off in a
/// line. Thread-safe; questions wait for no file.
class FollowedLogs {
 public:
  explicit FollowedLogs(std::vector<std::filesystem::path> files, LogFollowing following = {});
  ~FollowedLogs();
  FollowedLogs(const FollowedLogs&) = delete;
  FollowedLogs& operator=(const FollowedLogs&) = delete;

  /// What was known at a time.
  [[nodiscard]] TrafficHeard heard(UtcTime at) const;

 private:
  /// What tells one state of a file from another.
  struct Mark {
    std::uint64_t device = 0, file = 0, size = 0;
    std::int64_t written_ns = 0;
    bool operator==(const Mark&) const = default;
  };
  struct Log {
    std::filesystem::path path;
    std::string name;
    std::string trouble;         ///< guarded by `mutex_`
    std::optional<Mark> mark{};  ///< of the last reading
    std::string beginning{};     ///< its first bytes, then
    std::uint64_t read_to = 0;
    std::chrono::steady_clock::time_point not_before{};
  };
  void follow();
  void look_at(Log& log);
  /// What is wrong with what it reads; empty: nothing.
  [[nodiscard]] std::string read(Log& log, const std::filesystem::path& opened, const Mark& mark);
  void set_trouble(Log& log, std::string trouble);

  LogFollowing following_;
  std::vector<Log> logs_;
  mutable std::mutex mutex_;
  HeardVessels vessels_;
  std::condition_variable wake_;
  bool ends_ = false;
  std::thread thread_;
};

}  // namespace slackwater::api::desk
