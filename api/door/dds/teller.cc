#include "api/door/dds/teller.h"

namespace slackwater::dds {

Teller::Teller(Tell tell) : tell_(std::move(tell)), thread_([this] { tell_all(); }) {}

void Teller::tell(const std::string& text) noexcept {
  constexpr std::size_t most_waiting = 1000;
  try {
    const std::lock_guard lock(mutex_);
    if (!is_over_ && waiting_.size() < most_waiting) waiting_.push_back(text);
  } catch (...) {  // Nobody is left to tell.
  }
  came_.notify_one();
}

void Teller::end() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  came_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void Teller::tell_all() {
  std::unique_lock lock(mutex_);
  while (true) {
    came_.wait(lock, [&] { return is_over_ || !waiting_.empty(); });
    if (waiting_.empty()) return;
    const std::string text = std::move(waiting_.front());
    waiting_.pop_front();
    lock.unlock();
    try {
      tell_(text);
    } catch (...) {  // Nobody is left to tell.
    }
    lock.lock();
  }
}

}  // namespace slackwater::dds
