#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "api/door/people/action_keeper.h"
#include "api/door/people/session.h"

namespace slackwater::people {

/// A session of a live run whose record is filed in the store while it goes on.
class KeptSession {
 public:
  /// @param settings    its `keep` is told of each row besides
  /// @param filed_as    its name in the store
  /// @param on_trouble  told once where the store takes no more; from any thread
  /// @throws Error where the store cannot be written
  KeptSession(SessionSettings settings, TokenBook book, const std::filesystem::path& store_folder,
              const std::string& filed_as, std::function<void(const std::string&)> on_trouble);
  ~KeptSession() { end(); }
  KeptSession(const KeptSession&) = delete;
  KeptSession& operator=(const KeptSession&) = delete;

  /// Joins a run that is about to begin; on the thread of the run.
  void begin(const api::RunInHand& hand) { session_->begin(hand); }
  /// The run is over: tells the stations, and returns once all rows are filed. From one thread.
  void end();
  [[nodiscard]] std::vector<Action> actions() const { return session_->actions(); }
  [[nodiscard]] const std::shared_ptr<Session>& session() const noexcept { return session_; }

 private:
  std::unique_ptr<ActionKeeper> keeper_;
  std::shared_ptr<Session> session_;
};

}  // namespace slackwater::people
