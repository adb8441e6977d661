#pragma once
#include <optional>
#include <string>

#include "api/door/people/action.h"
#include "api/door/people/connection.h"
#include "twin/helm/refusal.h"

namespace slackwater::people {

/// Sticks that follow on each other: one row of the record at their beginning, one at their end.
struct StickRow {
  Action row;                            ///< of the first one
  std::optional<twin::Refusal> refused;  ///< likewise
  std::uint64_t count = 0;
  Milliseconds last_at = 0;
  std::size_t vehicle = 0;
};

/// What a station is turned out for that does more than its `deeds`.
inline constexpr const char* many_deeds =
    "found more than 10 orders a second (beside sticks and trials); send fewer";

/// A connection of a session, with or without a seat.
struct Station : Connection {
  std::string token;        ///< that it came with; emptied once it has a seat
  unsigned seat = 0;        ///< 0: it has not said hello
  Allowance deeds{10, 60};  ///< those that leave a row in the record
  std::optional<StickRow> stick;
  std::string attends_to;   ///< where it has that kept; empty: nothing with a name
  bool is_unheard = false;  ///< its helms are lost until it says something
};

}  // namespace slackwater::people
