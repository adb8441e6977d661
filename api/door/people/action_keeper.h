#pragma once
#include <condition_variable>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "data/store/store.h"

namespace slackwater::people {

/// Files the rows of a session in the store while it goes on, on a thread of its own, so that who
/// is killed leaves a record: a row is on the disk within moments of the deed. Thread-safe.
class ActionKeeper {
 public:
  /// @param on_trouble  told once where the store takes no more; the rows stay in the run's log
  /// @throws Error where the store cannot be written
  ActionKeeper(const std::filesystem::path& store_folder, const std::string& name, UtcTime begun,
               std::function<void(const std::string&)> on_trouble);
  /// Files what waits.
  ~ActionKeeper();
  ActionKeeper(const ActionKeeper&) = delete;
  ActionKeeper& operator=(const ActionKeeper&) = delete;

  void keep(const store::SessionAction& action);
  /// Of the session in the store.
  [[nodiscard]] std::int64_t id() const noexcept { return id_; }

 private:
  void file(const std::stop_token& over);

  store::Store store_;
  std::int64_t id_;
  std::function<void(const std::string&)> on_trouble_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::vector<store::SessionAction> waiting_;
  std::jthread thread_;  ///< goes first
};

}  // namespace slackwater::people
