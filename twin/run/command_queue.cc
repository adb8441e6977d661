#include "twin/run/command_queue.h"

#include <algorithm>
#include <iterator>

namespace slackwater::twin {
namespace {

bool is_before(std::uint64_t step, const Command& command) { return step < command.step; }

}  // namespace

void CommandQueue::put(Command command) {
  const std::lock_guard lock(mutex_);
  const auto after = std::upper_bound(waiting_.begin(), waiting_.end(), command.step, is_before);
  waiting_.insert(after, std::move(command));
  note_first();
}

std::vector<Command> CommandQueue::take(std::uint64_t step) {
  if (first_step_.load(std::memory_order_acquire) > step) return {};
  const std::lock_guard lock(mutex_);
  const auto later = std::upper_bound(waiting_.begin(), waiting_.end(), step, is_before);
  std::vector<Command> due(std::make_move_iterator(waiting_.begin()),
                           std::make_move_iterator(later));
  waiting_.erase(waiting_.begin(), later);
  note_first();
  return due;
}

std::vector<Command> CommandQueue::waiting() const {
  const std::lock_guard lock(mutex_);
  return {waiting_.begin(), waiting_.end()};
}

void CommandQueue::restore(std::vector<Command> waiting) {
  const std::lock_guard lock(mutex_);
  waiting_.assign(std::make_move_iterator(waiting.begin()), std::make_move_iterator(waiting.end()));
  note_first();
}

void CommandQueue::note_first() {
  first_step_.store(waiting_.empty() ? never : waiting_.front().step, std::memory_order_release);
}

}  // namespace slackwater::twin
