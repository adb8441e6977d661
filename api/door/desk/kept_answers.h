#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <mutex>
#include <string>

#include "api/door/http/message.h"
#include "fields/base/time.h"

namespace slackwater::api::desk {

/// What the answers of a store rest on, as far as files tell: its catalogue, its sites and plans,
/// and the task sheets. Two equal marks: nothing was written between.
[[nodiscard]] std::string mark_of(const std::filesystem::path& store_folder,
                                  const std::filesystem::path& data_folder);

/// Answers that many ask for at once, and again: each is worked out once, and kept until the store
/// changes or the server's clock shows the next five minutes: starts that have passed lie on such
/// times. Where they are too many or too much, the oldest go first. Thread-safe.
class KeptAnswers {
 public:
  using Make = std::function<http::Response()>;
  static constexpr std::size_t most_kept = 64;
  static constexpr std::size_t most_bytes = 64U << 20U;  ///< of bodies, all together
  KeptAnswers(std::filesystem::path store_folder, std::filesystem::path data_folder,
              std::function<UtcTime()> now, std::size_t most = most_bytes);

  /// @param question  the same for the same answer; @throws what `make` throws, which is not kept
  [[nodiscard]] http::Response answer(const std::string& question, const Make& make);
  /// From now on all is worked out anew, also what is being worked out.
  void forget();
  [[nodiscard]] std::size_t kept_bytes() const;

 private:
  using Pending = std::shared_future<std::shared_ptr<const http::Response>>;
  struct Kept {
    Pending response;
    std::string mark;
    std::size_t number = 0;
    std::size_t bytes = 0;  ///< once it is worked out
  };
  void make_room();
  void drop(std::map<std::string, Kept>::iterator kept);
  void weigh(const std::string& question, std::size_t number, std::size_t bytes);

  std::filesystem::path store_folder_, data_folder_;
  std::function<UtcTime()> now_;
  std::size_t most_;
  mutable std::mutex mutex_;
  std::map<std::string, Kept> kept_;
  std::size_t last_ = 0, bytes_ = 0;
};

}  // namespace slackwater::api::desk
