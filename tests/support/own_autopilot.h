#pragma once
#include <memory>

#include "twin/agent/agent.h"

namespace slackwater::tests {

/// Gives a vehicle an autopilot of its own, with other settings than those of its kind.
template <typename Change>
void change_autopilot(twin::Agent& agent, Change&& change) {
  auto own = std::make_shared<twin::Autopilot>(*agent.autopilot);
  change(own->settings);
  agent.autopilot = std::move(own);
}

}  // namespace slackwater::tests
