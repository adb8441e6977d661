#pragma once
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>

namespace slackwater {

/// A shared value that one swaps while many read. Readers never wait: not for a lock, not for a
/// writer that was put to sleep in the middle of a swap. (`std::atomic<std::shared_ptr>` of GCC 12
/// spins on a lock bit.)
///
/// Two copies of the pointer, readers counted apart on either side; a writer changes the copy that
/// nobody reads, sends new readers there, waits for the last of the others, and changes theirs
/// (Ramalhete and Correia 2015, "Left-Right: a concurrency control technique with wait-free
/// population oblivious reads").
template <typename T>
class Published {
 public:
  explicit Published(std::shared_ptr<const T> first = nullptr) : copy_{first, first} {}

  /// What is published now; the caller keeps it alive as long as it likes. Wait-free.
  [[nodiscard]] std::shared_ptr<const T> load() const noexcept {
    const std::uint32_t side = version_.load();
    readers_[side].count.fetch_add(1);
    std::shared_ptr<const T> value = copy_[copy_to_read_.load()];
    readers_[side].count.fetch_sub(1);
    return value;
  }

  /// Publishes; returns when no reader sees the old value any more (those that hold it keep it).
  void store(std::shared_ptr<const T> value) {
    const std::lock_guard lock(writers_);
    const std::uint32_t read = copy_to_read_.load();
    const std::uint32_t other = 1 - read;
    copy_[other] = value;
    copy_to_read_.store(other);
    const std::uint32_t side = version_.load();
    wait_for_readers(1 - side);
    version_.store(1 - side);
    wait_for_readers(side);
    copy_[read] = std::move(value);
  }

 private:
  void wait_for_readers(std::uint32_t side) const noexcept {
    while (readers_[side].count.load() != 0) std::this_thread::yield();
  }

  struct alignas(64) Readers {
    std::atomic<std::int64_t> count{0};
  };
  std::shared_ptr<const T> copy_[2];
  std::atomic<std::uint32_t> copy_to_read_{0};
  std::atomic<std::uint32_t> version_{0};
  mutable Readers readers_[2];
  std::mutex writers_;
};

}  // namespace slackwater
