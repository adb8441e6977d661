#pragma once
#include "fields/base/config.h"
#include "twin/thruster/thruster.h"

namespace slackwater::twin {

inline constexpr Range diameter_range{0.01, 10};
inline constexpr Range efficiency_range{0.01, 1};
inline constexpr Range shaft_speed_range{0.1, 1e4};

[[nodiscard]] double disc_area_m2(double diameter_m);
[[nodiscard]] double read_full_speed_voltage(const Config& c);

/// The numbers of a thruster of kind propeller: one of its thrust by the square of its speed, with
/// or without dimension, and its thrust and torque in open water.
void read_propeller(const Config& c, Thruster& thruster);

}  // namespace slackwater::twin
