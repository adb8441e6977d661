#pragma once
#include <cstddef>
#include <string>

#include "twin/body/attitude.h"

namespace slackwater::twin {

inline constexpr std::size_t most_mounts = 8;
inline constexpr std::size_t most_thruster_kinds = 4;  ///< of a vehicle

/// Where a thruster stands and which way it pushes, body axes.
struct Mount {
  Triple<double> position_m;
  Triple<double> direction;  ///< of positive thrust; of length one
  /// +1: its propeller turns clockwise seen along the thrust, and the vehicle the other way
  double spin = 1;
  std::size_t kind = 0;  ///< which of the vehicle's kinds of thruster stands there
  std::string name{};    ///< of the thruster there, unlike those of the others
};

/// A pair of fins: a rudder, upright, or an elevator, across.
struct FinPair {
  double area_m2 = 0;       ///< of the pair; 0: none
  double position_x_m = 0;  ///< negative: aft
  double lift_slope_per_rad = 0;
  double drag_factor = 0;  ///< drag coefficient over the square of the lift coefficient
  double stall_rad = 0;
  double limit_rad = 0;
  double rate_rad_s = 0;
  /// Lift slope of the flow's incidence over that of the deflection, `lift_slope_per_rad`; 0: the
  /// hull's own derivatives have what the fins do amidships.
  double passive_share = 1;
  double lag_s = 0;  ///< time constant of their approach to what is asked, within their rate
};

/// A mass that slides along x and a bladder that changes the volume.
struct Trim {
  double moving_mass_kg = 0;
  double travel_m = 0;  ///< either way
  double travel_rate_m_s = 0;
  double least_volume_m3 = 0;  ///< against neutral
  double most_volume_m3 = 0;
  double volume_rate_m3_s = 0;
};

}  // namespace slackwater::twin
