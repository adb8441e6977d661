#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "api/door/live/command_door.h"
#include "api/door/live/topics/stream.h"
#include "data/store/session_action.h"

namespace slackwater::live {

/// Where a session of people leaves what was done in it, for the run to tell. Thread-safe.
class ActionPost {
 public:
  void put(const store::SessionAction& action) {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(action);
  }
  /// In order, each once.
  [[nodiscard]] std::vector<store::SessionAction> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(waiting_, {});
  }

 private:
  std::mutex mutex_;
  std::vector<store::SessionAction> waiting_;
};

/// The topic of a session's record: std_msgs/msg/String with a row each as JSON
/// (api/docs/session.md).
inline constexpr const char* action_topic = "/slackwater/session/actions";

/// Records what people do in a run, at the barrier after the deed: those of a session that is under
/// way, or those of a log from which a run is made again. A row's time in a recording is that of
/// the run, as all else has it there; in the row stands the clock of the wall.
class ActionTeller {
 public:
  /// @param post       null: no session is under way
  /// @param on_record  of the run that is made again; they outlive it
  ActionTeller(Stream& stream, const RunPlace& place, std::shared_ptr<ActionPost> post,
               std::span<const store::SessionAction> on_record);
  /// At a barrier.
  void speak(double t_s);
  /// Once the last step is made: what was done since.
  void finish();

 private:
  void tell(const store::SessionAction& action);

  Stream& stream_;
  RunPlace place_;
  std::shared_ptr<ActionPost> post_;
  std::span<const store::SessionAction> left_;
  std::optional<Stream::ChannelId> channel_;  ///< nothing: nobody takes part
};

}  // namespace slackwater::live
