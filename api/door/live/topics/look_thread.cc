#include "api/door/live/topics/look_thread.h"

#include <algorithm>
#include <exception>

namespace slackwater::live {

LookThread::LookThread(std::size_t sensors,
                       std::function<void(std::size_t, const std::string&)> on_unseen)
    : on_unseen_(std::move(on_unseen)), sensors_(sensors), thread_([this] { make_all(); }) {}

void LookThread::hand_in(std::size_t sensor, Look look) {
  std::optional<Waiting> waiting(Waiting{std::move(look), WallClock::now()});
  {
    const std::lock_guard lock(mutex_);
    if (is_over_) return;
    Sensor& of = sensors_.at(sensor);
    ++of.made.moments;
    of.made.dropped += of.waiting ? 1U : 0U;
    if (!of.waiting) of.turn = ++turns_;
    of.waiting.swap(waiting);  // what is dropped goes without the lock
  }
  came_.notify_one();
}

LookThread::Sensor* LookThread::next() {
  Sensor* first = nullptr;
  for (Sensor& sensor : sensors_)
    if (sensor.waiting && (first == nullptr || sensor.turn < first->turn)) first = &sensor;
  return first;
}

void LookThread::make_all() {
  std::unique_lock lock(mutex_);
  for (;;) {
    Sensor* sensor = nullptr;
    came_.wait(lock, [&] { return (sensor = next()) != nullptr || is_over_; });
    if (sensor == nullptr) return;
    const Waiting waiting = *std::exchange(sensor->waiting, std::nullopt);
    lock.unlock();
    std::string unseen;
    bool is_seen = true;
    try {
      waiting.look();
    } catch (const std::exception& problem) {
      is_seen = false;
      unseen = problem.what();
    }
    const double took_s = std::chrono::duration<double>(WallClock::now() - waiting.since).count();
    lock.lock();
    LooksMade& made = sensor->made;
    if (is_seen) {
      ++made.looks;
      made.sum_s += took_s;
      made.worst_s = std::max(made.worst_s, took_s);
    } else if (++made.unseen == 1 && on_unseen_) {
      lock.unlock();
      on_unseen_(static_cast<std::size_t>(sensor - sensors_.data()), unseen);
      lock.lock();
    }
  }
}

void LookThread::finish() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  came_.notify_one();
  if (thread_.joinable()) thread_.join();
}

LooksMade LookThread::made(std::size_t sensor) const {
  const std::lock_guard lock(mutex_);
  return sensors_.at(sensor).made;
}

}  // namespace slackwater::live
