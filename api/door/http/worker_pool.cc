#include "api/door/http/worker_pool.h"

#include "fields/base/check.h"

namespace slackwater::api::http {

WorkerPool::WorkerPool(std::size_t threads) {
  expects(threads > 0, "a pool has a thread");
  for (std::size_t i = 0; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() { stop(); }

void WorkerPool::submit(const std::string& client, std::function<void()> job) {
  {
    const std::lock_guard lock(mutex_);
    Jobs& jobs = jobs_[client];
    if (jobs.empty()) turns_.push_back(client);
    jobs.push_back(std::move(job));
  }
  changed_.notify_one();
}

void WorkerPool::stop() {
  std::map<std::string, Jobs> forgotten;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    forgotten.swap(jobs_);
    turns_.clear();
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void WorkerPool::work() {
  for (;;) {
    std::function<void()> job;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [&] { return stopping_ || !turns_.empty(); });
      if (turns_.empty()) return;
      job = take();
    }
    job();
  }
}

std::function<void()> WorkerPool::take() {
  const auto of_client = jobs_.find(turns_.front());
  Jobs& jobs = of_client->second;
  std::function<void()> job = std::move(jobs.front());
  jobs.pop_front();
  if (jobs.empty()) {
    jobs_.erase(of_client);
  } else {
    turns_.push_back(turns_.front());
  }
  turns_.pop_front();
  return job;
}

}  // namespace slackwater::api::http
