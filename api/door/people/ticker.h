#pragma once
#include <chrono>
#include <functional>
#include <thread>

namespace slackwater::people {

/// Twenty times a second, on a thread of its own, until it goes or a tick says that it was the
/// last. What it works on goes after it: it is the last member.
class Ticker {
 public:
  /// @param tick  returns whether there is to be another one
  explicit Ticker(std::function<bool()> tick)
      : thread_([tick = std::move(tick)](const std::stop_token& over) {
          auto next = std::chrono::steady_clock::now();
          while (!over.stop_requested()) {
            next += std::chrono::milliseconds(50);
            std::this_thread::sleep_until(next);
            if (!tick()) return;
          }
        }) {}

 private:
  std::jthread thread_;
};

}  // namespace slackwater::people
