#pragma once
#include <functional>
#include <vector>

#include "data/store/session_action.h"

namespace slackwater::people {

using Action = store::SessionAction;

/// The row of what somebody looked at who wanted it kept: of the record alone.
inline constexpr const char* attend_row = "attend";
/// Whether those who take part are told a row.
[[nodiscard]] inline bool is_told(const Action& action) { return action.what != attend_row; }

/// What was done in a session, in order. Not thread-safe.
class ActionRecord {
 public:
  /// @param keep  told of each row at once; waits for nothing
  explicit ActionRecord(std::function<void(const Action&)> keep = {}) : keep_(std::move(keep)) {}
  const Action& add(Action action);
  [[nodiscard]] const std::vector<Action>& all() const noexcept { return all_; }

 private:
  std::function<void(const Action&)> keep_;
  std::vector<Action> all_;
};

}  // namespace slackwater::people
