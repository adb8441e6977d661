#pragma once
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "api/door/people/action.h"
#include "api/door/people/helms.h"
#include "twin/run/command.h"
#include "twin/state/helm_rule.h"

namespace slackwater::people {

/// Whose helm a vehicle's was, and what it was told, from a time on.
struct LoggedHelm {
  double from_s = 0;
  HelmPhase phase = HelmPhase::free;
  std::string holder, asker;  ///< by their names; empty: nobody
  bool is_raw = false;
  twin::HelmMode mode = twin::HelmMode::own;
  twin::HelmCause cause = twin::HelmCause::none;
  [[nodiscard]] bool is_like(const LoggedHelm& other) const {
    return phase == other.phase && holder == other.holder && asker == other.asker &&
           is_raw == other.is_raw && mode == other.mode && cause == other.cause;
  }
};

/// Of which vehicle, and how it goes when nobody speaks to it.
struct StoryOf {
  std::size_t vehicle = 0;  ///< its place in the run
  std::string name;
  twin::HelmRule rule;
  double until_s = std::numeric_limits<double>::infinity();  ///< it halted, or the log ends
};

/// The helm of a vehicle as the log of a run tells it, by time; the first one is of the start. Who
/// held it is in the record of people's actions. What it was told is in the commands, and what
/// follows from nobody's renewing them is by `helm_due`. When a list of waypoints was done the log
/// does not say, nor when a leave that the holder gave to all was over: the mode stays what it was
/// told last, and the helm its holder's.
[[nodiscard]] std::vector<LoggedHelm> helm_story(const StoryOf& of, std::span<const Action> actions,
                                                 std::span<const twin::Command> commands,
                                                 double step_s);

}  // namespace slackwater::people
