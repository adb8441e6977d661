#pragma once
#include <chrono>
#include <string>

namespace slackwater::api {

/// A progress bar on stderr, drawn only on a terminal and only once a second of work has passed.
class ProgressBar {
 public:
  explicit ProgressBar(std::string title, bool quiet = false);
  ~ProgressBar();
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;
  /// Share of the work done, in [0, 1].
  void update(double share);

 private:
  std::string title_;
  bool on_;
  bool drawn_ = false;
  int last_percent_ = -1;
  std::chrono::steady_clock::time_point start_;
};

}  // namespace slackwater::api
