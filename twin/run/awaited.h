#pragma once
#include <cstdint>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace slackwater::twin {

/// For whom a run stands still within a step: other processes that make a part of it, and have not
/// answered yet. The run's threads say so, others look. Thread-safe.
class Awaited {
 public:
  /// As long as it is there, the run waits for somebody.
  class Wait {
   public:
    Wait(Awaited& awaited, std::string whom) : awaited_(awaited) {
      const std::lock_guard lock(awaited_.mutex_);
      number_ = ++awaited_.last_;
      awaited_.waits_.emplace_back(number_, std::move(whom));
    }
    ~Wait() {
      const std::lock_guard lock(awaited_.mutex_);
      std::erase_if(awaited_.waits_, [&](const auto& wait) { return wait.first == number_; });
    }
    Wait(const Wait&) = delete;
    Wait& operator=(const Wait&) = delete;

   private:
    Awaited& awaited_;
    std::uint64_t number_ = 0;
  };

  /// Who was waited for first, of those that still are; empty: nobody.
  [[nodiscard]] std::string whom() const {
    const std::lock_guard lock(mutex_);
    return waits_.empty() ? std::string() : waits_.front().second;
  }

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<std::uint64_t, std::string>> waits_;
  std::uint64_t last_ = 0;
};

}  // namespace slackwater::twin
