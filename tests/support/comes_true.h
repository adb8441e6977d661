#pragma once
#include <chrono>
#include <functional>
#include <thread>

namespace slackwater::tests {

/// Whether it comes true within the time.
inline bool comes_true(const std::function<bool()>& is_so,
                       std::chrono::milliseconds most = std::chrono::seconds(20)) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (!is_so()) {
    if (std::chrono::steady_clock::now() > end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return true;
}

}  // namespace slackwater::tests
