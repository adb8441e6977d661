#pragma once
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace slackwater::api::http {

/// Threads that run the jobs of clients in turns, one of each, and those of one client in the order
/// they came: who asks for a thousand things waits for itself. The queue has no bound of its own: a
/// connection has one request at a time.
class WorkerPool {
 public:
  explicit WorkerPool(std::size_t threads);
  ~WorkerPool();  ///< stops
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  /// Jobs must not throw.
  /// @param client  whose job it is
  void submit(const std::string& client, std::function<void()> job);
  /// Forgets the jobs that have not begun and waits for the others.
  void stop();

 private:
  using Jobs = std::deque<std::function<void()>>;

  void work();
  /// The next job of the client whose turn it is, who is then the last. There is one.
  std::function<void()> take();

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, Jobs> jobs_;  ///< by client; none is empty
  std::deque<std::string> turns_;     ///< the clients of `jobs_`, the next one first
  bool stopping_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace slackwater::api::http
