#pragma once
#include <array>
#include <span>
#include <string>
#include <vector>

#include "api/door/dds/message/bytes.h"
#include "twin/body/attitude.h"

namespace slackwater::dds {

// The action slackwater_msgs/action/Navigate: three services and two topics.

using GoalId = std::array<std::uint8_t, 16>;

/// As action_msgs/msg/GoalStatus counts them.
enum class GoalStatus : std::int8_t {
  accepted = 1,
  executing = 2,
  canceling = 3,
  succeeded = 4,
  canceled = 5,
  aborted = 6,
};
[[nodiscard]] constexpr bool is_over(GoalStatus status) noexcept {
  return status >= GoalStatus::succeeded;
}

struct GoalInfo {
  GoalId id{};
  Stamp accepted_at;
};

struct GoalAsked {
  GoalId id{};
  std::vector<twin::Triple<double>> places_m;  ///< NED
};
/// @throws Error(invalid_input) for bytes that are no such request, like all of these
[[nodiscard]] GoalAsked read_send_goal(Payload request);
[[nodiscard]] Bytes send_goal_reply(bool accepted, const Stamp& stamp);

/// An id of zeros asks for all goals, up to the stamp where that is not zero.
[[nodiscard]] GoalInfo read_cancel_goal(Payload request);
enum class CancelAnswer : std::int8_t { none = 0, rejected = 1, unknown_goal = 2, is_over = 3 };
[[nodiscard]] Bytes cancel_goal_reply(CancelAnswer answer, std::span<const GoalInfo> canceling);

[[nodiscard]] GoalId read_get_result(Payload request);
[[nodiscard]] Bytes result_reply(GoalStatus status, bool success, const std::string& message);
/// For a goal that is not known: status 0.
[[nodiscard]] Bytes unknown_result_reply();

/// @param waypoint  that is gone for, the first is 0; @param distance_m  to it
[[nodiscard]] Bytes feedback(const GoalId& id, std::uint32_t waypoint, double distance_m);

struct GoalState {
  GoalInfo goal;
  GoalStatus status = GoalStatus::accepted;
};
/// action_msgs/msg/GoalStatusArray.
[[nodiscard]] Bytes goal_status(std::span<const GoalState> goals);

}  // namespace slackwater::dds
