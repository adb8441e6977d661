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
/// times. Thread-safe.
class KeptAnswers {
 public:
  using Make = std::function<http::Response()>;
  KeptAnswers(std::filesystem::path store_folder, std::filesystem::path data_folder,
              std::function<UtcTime()> now);

  /// @param question  the same for the same answer; @throws what `make` throws, which is not kept
  [[nodiscard]] http::Response answer(const std::string& question, const Make& make);
  /// From now on all is worked out anew, also what is being worked out.
  void forget();

 private:
  using Pending = std::shared_future<std::shared_ptr<const http::Response>>;
  struct Kept {
    Pending response;
    std::string mark;
    std::size_t number = 0;
  };
  void make_room();

  std::filesystem::path store_folder_, data_folder_;
  std::function<UtcTime()> now_;
  std::mutex mutex_;
  std::map<std::string, Kept> kept_;
  std::size_t last_ = 0;
};

}  // namespace slackwater::api::desk
