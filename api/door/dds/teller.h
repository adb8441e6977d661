#pragma once
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace slackwater::dds {

/// Hands on what people should know of, in order, from a thread of its own: who finds it out may be
/// inside the library and hold its locks. `tell` is for any thread.
class Teller {
 public:
  using Tell = std::function<void(const std::string&)>;
  /// @param tell  what it throws is nobody's
  explicit Teller(Tell tell);
  ~Teller() { end(); }
  Teller(const Teller&) = delete;
  Teller& operator=(const Teller&) = delete;

  /// What comes faster than it can be told, by a thousand, is dropped.
  void tell(const std::string& text) noexcept;
  /// When all that was told until now is handed on. Nothing is told after it.
  void end();

 private:
  void tell_all();

  Tell tell_;
  std::mutex mutex_;
  std::condition_variable came_;
  std::deque<std::string> waiting_;
  bool is_over_ = false;
  std::thread thread_;
};

}  // namespace slackwater::dds
