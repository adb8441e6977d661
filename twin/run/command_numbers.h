#pragma once
#include <span>
#include <string_view>
#include <vector>

#include "twin/run/command.h"

namespace slackwater::twin {

// A command's content as a list of numbers, for what stores commands and takes them up again.
//
// | kind (`name_of`)      | numbers                                                             |
// |-----------------------|---------------------------------------------------------------------|
// | waypoints             | 1 for a loop, else 0; of each: north, east, down (m), speed (m/s),  |
// |                       | 1 where that is over ground, else 0                                 |
// | velocity              | surge, sway, heave (m/s, down), yaw rate (rad/s)                    |
// | thrusters             | a share each                                                        |
// | actuators             | 1 for values in units, 0 for shares; a value for each of the 12     |
// |                       | channels; 1 for each that is given one, else 0                      |
// | hold                  | 1 where the client was lost, else 0                                 |
// | home, resume          | none                                                                |
// | put                   | `VehicleState<double>` as it lies in memory                         |
// | host                  | 1 for physics made elsewhere, 0 for our own again                   |
// | spawn                 | letters of the model, their codes; letters of the name, their codes;|
// |                       | north, east, down (m), heading (rad)                                |

[[nodiscard]] std::vector<double> numbers_of(const CommandWhat& what);
/// A vehicle that joins is not made ready by that.
/// @throws Error(invalid_input) for an unknown kind, or numbers that are none of it
[[nodiscard]] CommandWhat what_of(std::string_view kind, std::span<const double> numbers);

}  // namespace slackwater::twin
