#pragma once
#include <map>
#include <span>
#include <string>

#include "data/store/session_action.h"

namespace slackwater::api {

/// What somebody looked at who had that kept, s on the clock of the wall.
struct Attention {
  double kept_s = 0;                   ///< for how long it was kept
  std::map<std::string, double> on_s;  ///< by name; empty: nothing that has one
};

/// By seat, from the `attend` rows of a session's record; whoever had nothing kept is not there. An
/// object counts until the next row about it, a link that is cut, a seat that is left or taken up
/// again (elsewhere: a reload), or the last row of all; not where the clock was set back meanwhile.
/// @param actions  in order
[[nodiscard]] std::map<unsigned, Attention> attention_of(
    std::span<const store::SessionAction> actions);

}  // namespace slackwater::api
