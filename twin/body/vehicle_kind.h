#pragma once

namespace slackwater::twin {

enum class VehicleKind { rov, auv, uav, usv, vessel };

/// As vehicles' files have it: rov, auv, uav, usv, vessel.
[[nodiscard]] constexpr const char* name_of(VehicleKind kind) noexcept {
  constexpr const char* names[] = {"rov", "auv", "uav", "usv", "vessel"};
  return names[static_cast<int>(kind)];
}

}  // namespace slackwater::twin
