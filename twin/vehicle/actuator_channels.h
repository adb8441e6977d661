#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "twin/body/actuator_values.h"
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// What a channel of a vehicle takes, in the unit that its model is commanded in.
///
/// | channel             | unit                 | positive               | name                |
/// |---------------------|----------------------|------------------------|---------------------|
/// | thruster, table     | command, -1 to 1     | as its table has it    | of its mount        |
/// | thruster, propeller | rad/s of the shaft   | pushes along its mount | of its mount        |
/// | thruster, rotor     | rad/s                | pushes along its mount | of its mount        |
/// | thruster, drive     | N                    | pushes along its mount | of its mount        |
/// | rudder              | rad                  | bow to starboard       | `rudder`            |
/// | elevator            | rad                  | bow up                 | `elevator`          |
/// | moving mass         | m from its middle    | forward                | `moving_mass`       |
/// | volume              | m3 against neutral   | the vehicle rises      | `volume`            |
enum class ActuatorUnit { command, rad_s, n, rad, m, m3 };
/// "rad/s", "N", ...; of a command "".
[[nodiscard]] const char* symbol_of(ActuatorUnit unit) noexcept;

struct ActuatorChannel {
  std::string_view name;  ///< of the vehicle's own, or a literal
  ActuatorUnit unit{};
  double least = 0;
  double most = 0;

  /// Within its limits, or as good as: what a file or a door gives in round numbers is meant.
  [[nodiscard]] bool reaches(double value) const noexcept;
  /// What a share of its range is, -1 to 1: below 0 of the least, where that is below 0.
  [[nodiscard]] double of_share(double share) const noexcept;
};

/// Nothing: the vehicle has none there. Does not allocate.
[[nodiscard]] std::optional<ActuatorChannel> channel_of(const Vehicle& vehicle,
                                                        std::size_t channel) noexcept;
/// Nothing: none of its channels is called that.
[[nodiscard]] std::optional<std::size_t> channel_named(const Vehicle& vehicle,
                                                       std::string_view name) noexcept;
/// "left, right, rudder": all that it has.
[[nodiscard]] std::string channel_names(const Vehicle& vehicle);

/// What was given in shares, in units; within the range of each channel.
/// @param is_physical  it is in units already
[[nodiscard]] ActuatorValues in_units(const Vehicle& vehicle, const ActuatorValues& given,
                                      bool is_physical) noexcept;

/// By name. @throws Error(invalid_input) for a name that the vehicle has not, listing those it has,
/// one that is named twice, and for names and values of unlike number
[[nodiscard]] ActuatorValues values_by_name(const Vehicle& vehicle,
                                            std::span<const std::string> names,
                                            std::span<const double> values);

}  // namespace slackwater::twin
