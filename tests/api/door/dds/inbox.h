#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "tests/support/comes_true.h"

namespace slackwater::tests {

/// What other threads brought, waited for.
template <typename Item>
class Inbox {
 public:
  void put(Item item) {
    const std::lock_guard lock(mutex_);
    items_.push_back(std::move(item));
    changed_.notify_all();
  }
  /// All that came, as soon as there are so many or the time is over.
  [[nodiscard]] std::vector<Item> wait(std::size_t count = 1,
                                       std::chrono::milliseconds most = std::chrono::seconds(20)) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, most, [&] { return items_.size() >= count; });
    return items_;
  }
  [[nodiscard]] std::size_t size() {
    const std::lock_guard lock(mutex_);
    return items_.size();
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Item> items_;
};

}  // namespace slackwater::tests
