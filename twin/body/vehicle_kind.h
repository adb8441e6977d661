#pragma once

namespace slackwater::twin {

enum class VehicleKind { rov, auv, uav, usv, vessel };

}  // namespace slackwater::twin
