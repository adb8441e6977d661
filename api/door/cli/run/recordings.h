#pragma once
#include <filesystem>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/door/live/topics/recording_outlet.h"
#include "twin/run/run.h"

namespace slackwater::api {

/// The bags that a command records a run in (`--record`). Where the run ends in trouble before its
/// first step was made they are taken away again, so that the next try finds their places free.
class Recordings {
 public:
  /// @throws Error(invalid_input) where something lies at one of the paths
  explicit Recordings(std::vector<std::filesystem::path> paths);
  /// Completes those of a run that failed on its way; nobody is told of trouble with them.
  ~Recordings();
  Recordings(const Recordings&) = delete;
  Recordings& operator=(const Recordings&) = delete;

  [[nodiscard]] bool empty() const noexcept { return paths_.empty(); }
  /// Begins them, once all that a run may be refused for was looked at.
  /// @param run  lives no longer than this
  /// @throws Error(unavailable) where one cannot be made
  [[nodiscard]] std::vector<std::shared_ptr<live::Outlet>> open(twin::Run& run);
  /// Completes them, after the run.
  void close();

  /// Of those that are closed: `[{path, messages, complete}]`, messages that can be read back.
  [[nodiscard]] nlohmann::json json() const;
  /// @throws Error(unavailable) that names those which do not hold all of the run
  void expect_complete() const;

 private:
  struct Closed {
    std::filesystem::path path;
    std::uint64_t messages = 0;
    bool is_complete = false;
  };
  std::vector<std::filesystem::path> paths_;
  std::vector<std::shared_ptr<live::RecordingOutlet>> open_;  ///< of the first paths
  std::vector<Closed> closed_;
  bool has_stepped_ = false;
};

}  // namespace slackwater::api
