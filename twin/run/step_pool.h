#pragma once
#include <atomic>
#include <barrier>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace slackwater::twin {

/// Threads that share out the clients of a step and meet at its end. The threads live as long as
/// this; a step allocates nothing. One thread: all is done by the caller.
class StepPool {
 public:
  explicit StepPool(std::size_t threads);
  ~StepPool();
  StepPool(const StepPool&) = delete;
  StepPool& operator=(const StepPool&) = delete;

  /// Calls `work` with 0 to `count` - 1, each once, on any thread; returns when all are done. What
  /// a call throws is thrown here (the first of them), after the others have finished.
  void run(std::size_t count, const std::function<void(std::size_t)>& work);

 private:
  void take_work() noexcept;
  std::size_t count_ = 0;
  const std::function<void(std::size_t)>* work_ = nullptr;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> failed_{false};
  std::exception_ptr failure_;
  bool ends_ = false;
  std::barrier<> meet_;
  std::vector<std::jthread> threads_;
};

}  // namespace slackwater::twin
