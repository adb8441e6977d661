#pragma once
#include <cstdint>
#include <string>

#include "fields/base/time.h"

namespace slackwater::store {

/// What somebody did in a live run with people, or was refused.
struct SessionAction {
  std::uint64_t number = 0;  ///< within its session, from 1
  UtcTime at{};              ///< on the clock of the wall
  double time_s = 0;         ///< of the run
  std::uint64_t step = 0;    ///< of the run
  unsigned seat = 0;
  std::string who;      ///< the name of the seat
  std::string role;     ///< "spectator", "operator" or "supervisor"
  std::string what;     ///< as in the protocol (api/docs/session_wire.md): "ask", "stick", ...
  std::string vehicle;  ///< its name; empty: of the run, or the session
  std::string before, after;
  bool is_taken = true;
  std::string reason;       ///< of a refusal, as twin/helm/refusal.h names it; empty: taken
  std::string why;          ///< it was refused, or done where a reason was asked for
  std::uint64_t count = 1;  ///< of the end of sticks that followed on each other: how many
  bool operator==(const SessionAction&) const = default;
};

/// A live run in which people took part.
struct SessionRow {
  std::int64_t id = 0;
  std::string name;  ///< of the run
  UtcTime begun{};
  std::uint64_t actions = 0;
  bool operator==(const SessionRow&) const = default;
};

}  // namespace slackwater::store
