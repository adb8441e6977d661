#include "twin/run/step_pool.h"

#include <utility>

#include "fields/base/check.h"

namespace slackwater::twin {

StepPool::StepPool(std::size_t threads) : meet_(static_cast<std::ptrdiff_t>(threads)) {
  expects(threads > 0, "a step needs a thread");
  for (std::size_t i = 1; i < threads; ++i) {
    threads_.emplace_back([this] {
      while (true) {
        meet_.arrive_and_wait();
        if (ends_) return;
        take_work();
        meet_.arrive_and_wait();
      }
    });
  }
}

StepPool::~StepPool() {
  if (threads_.empty()) return;
  ends_ = true;
  meet_.arrive_and_wait();
}

void StepPool::run(std::size_t count, const std::function<void(std::size_t)>& work) {
  count_ = count;
  work_ = &work;
  next_ = 0;
  if (threads_.empty()) {
    take_work();
  } else {
    meet_.arrive_and_wait();
    take_work();
    meet_.arrive_and_wait();
  }
  if (failed_.exchange(false)) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void StepPool::take_work() noexcept {
  for (std::size_t i = next_++; i < count_; i = next_++) {
    try {
      (*work_)(i);
    } catch (...) {
      if (!failed_.exchange(true)) failure_ = std::current_exception();
    }
  }
}

}  // namespace slackwater::twin
