#pragma once
#include "twin/control/autopilot.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// V, of its bus: of its battery at rest and half full; of one without a battery the least at which
/// its thrusters give what they can; 0: they need none.
[[nodiscard]] double usual_voltage_v(const Vehicle& vehicle) noexcept;

/// The autopilot of a vehicle, worked out for the thrust that its mounts have at rest.
/// @param settings   those of the vehicle, as far as nobody changes them
/// @param voltage_v  of its bus
/// @throws Error(invalid_input) for a vehicle that this kind of autopilot cannot steer, and as
/// `expect_strength`
[[nodiscard]] Autopilot own_autopilot(const Vehicle& vehicle, const AutopilotSettings& settings,
                                      double voltage_v);

}  // namespace slackwater::twin
