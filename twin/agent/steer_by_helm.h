#pragma once
#include <optional>

#include "twin/agent/agent.h"
#include "twin/step/command_thrusters.h"

namespace slackwater::twin {

/// What a manoeuvre has in the place of the autopilot's: the propulsion of its approach, held, and
/// its helm. The rudder is put to it; without one it is a yaw moment of the thrusters, which has
/// precedence over the push ahead. Depth, and what keeps a vehicle upright, stay the autopilot's.
/// In the approach all of it does; the propulsion is noted then.
/// @param effort  what the autopilot asks for
/// @param before  what the autopilot knew before this step: what it would learn of a heading and a
///                speed that it does not keep is put back
/// @return what the thrusters are asked for; nothing: no helm is put over
[[nodiscard]] std::optional<Effort> command_by_helm(const Agent& agent, const Effort& effort,
                                                    const ControlState& before,
                                                    const ThrustersMeet& meet, AgentState& state,
                                                    VehicleCommand<double>& command);

}  // namespace slackwater::twin
