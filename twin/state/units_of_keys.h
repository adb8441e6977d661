#pragma once
#include <array>

#include "fields/base/constants.h"
#include "twin/scenario/actuator_table.h"
#include "twin/vehicle/actuator_channels.h"

namespace slackwater::twin {

/// What a key in a unit is worth in that of its channel. Of shares see `ActuatorChannel::of_share`.
struct UnitOfKey {
  KeyUnit key{};
  ActuatorUnit channel{};
  double scale = 1;
};
inline constexpr std::array<UnitOfKey, 6> units_of_keys{{
    {KeyUnit::rad_s, ActuatorUnit::rad_s, 1},
    {KeyUnit::rpm, ActuatorUnit::rad_s, 2 * constants::pi / 60},
    {KeyUnit::n, ActuatorUnit::n, 1},
    {KeyUnit::deg, ActuatorUnit::rad, constants::degree},
    {KeyUnit::m, ActuatorUnit::m, 1},
    {KeyUnit::m3, ActuatorUnit::m3, 1},
}};

}  // namespace slackwater::twin
