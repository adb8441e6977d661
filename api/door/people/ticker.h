#pragma once
#include <chrono>
#include <functional>
#include <thread>

namespace slackwater::people {

/// Twenty times a second, on a thread of its own, until it goes or the tick says it was the last. What it works on goes after it: it
/// is the last member.
class Ticker {
 public:
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
