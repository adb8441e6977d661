#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "api/door/people/wire/pose.h"
#include "twin/agent/agent.h"

namespace slackwater::people {

/// A vehicle at one time of its log.
struct LoggedRow {
  bool is_there = false;  ///< else it had not joined, and the rest says nothing
  Pose pose;
  std::size_t task = 0;
  twin::Halt halt = twin::Halt::none;
};

/// A moment by the rows of a log: so much of the way from a row to the next one.
struct Moment {
  std::size_t row = 0;
  double share = 0;  ///< 0 to below 1
};

/// @param t_s  of the rows, ascending, not empty
/// @param at_s  before the first row counts as it, and after the last as that one
[[nodiscard]] Moment moment_of(std::span<const double> t_s, double at_s) noexcept;

/// Where the vehicle was: between two rows on the straight way, its angles the short way round.
/// Nothing where it was not there at either of them: the log does not tell when it came.
[[nodiscard]] std::optional<Pose> pose_at(std::span<const LoggedRow> rows, const Moment& moment);

}  // namespace slackwater::people
