#pragma once
#include <span>
#include <string>

#include "twin/run/set_up.h"
#include "twin/scenario/expand_mission.h"

namespace slackwater::twin {

/// That each vehicle is one that the task can be done with: of its kinds, with the instruments that
/// it needs, as deep as it may go, within its tether's length as the crow flies, and with the
/// energy for each sortie in still water.
/// @throws Error(invalid_input) that says which, what was found and what to do
void expect_fit(const ExpandedMission& mission, const ReadyRun& ready);

}  // namespace slackwater::twin
