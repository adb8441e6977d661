#pragma once
#include <array>
#include <cstddef>

#include "twin/body/actuators.h"

namespace slackwater::twin {

// What of a vehicle can be commanded, by channel: its thrusters in the order of its mounts, then
// these four. What a vehicle has of them, and what they are called, says actuator_channels.h.
inline constexpr std::size_t rudder_channel = most_mounts;
inline constexpr std::size_t elevator_channel = most_mounts + 1;
inline constexpr std::size_t moving_mass_channel = most_mounts + 2;
inline constexpr std::size_t volume_channel = most_mounts + 3;
inline constexpr std::size_t most_channels = most_mounts + 4;

/// A value for each channel that is given one. Numbers only.
struct ActuatorValues {
  std::array<double, most_channels> value{};
  std::array<double, most_channels> is_given{};  ///< 1: it is

  void give(std::size_t channel, double of) noexcept {
    value[channel] = of;
    is_given[channel] = 1;
  }
  [[nodiscard]] bool has(std::size_t channel) const noexcept { return is_given[channel] > 0.5; }
  [[nodiscard]] double value_or(std::size_t channel, double otherwise) const noexcept {
    return has(channel) ? value[channel] : otherwise;
  }
  bool operator==(const ActuatorValues&) const = default;
};

}  // namespace slackwater::twin
