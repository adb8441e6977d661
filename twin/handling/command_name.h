#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// What a column of commands says by its name: a channel of the vehicle and a unit, as
/// `rudder_deg`, `left_propeller_rad_s`, `propeller_rpm`, `volume_m3`, `left_share`.
struct CommandName {
  std::size_t channel = 0;
  bool is_share = false;
  double si = 1;  ///< what one of its unit is in the channel's
};
/// Nothing: it names no channel of the vehicle, or none in this unit.
[[nodiscard]] std::optional<CommandName> command_name(const Vehicle& vehicle,
                                                      std::string_view column) noexcept;
/// All names that `command_name` knows of a vehicle, channel by channel.
[[nodiscard]] std::vector<std::string> command_names(const Vehicle& vehicle);

}  // namespace slackwater::twin
