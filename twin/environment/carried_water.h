#pragma once
#include <array>
#include <cstddef>

#include "twin/environment/environment.h"
#include "twin/tether/tether.h"

namespace slackwater::twin {

/// The vehicle, then the inner nodes of its tether from the top. The ends of the line have the
/// water of the vehicle and of the first inner node.
inline constexpr std::size_t carried_places = tether_inner_nodes + 1;

/// Where water is wanted and how the places move, NED; `count` is 1 without a tether.
struct MovingPlaces {
  std::array<Triple<double>, carried_places> at_m{};
  std::array<Triple<double>, carried_places> velocity_m_s{};
  std::size_t count = 1;
  double vehicle_height_m = 0;
};

/// What was found at one look at each place, NED. Numbers only.
struct WaterLook {
  std::array<double, carried_places> at_s{};  ///< when; all nodes are not looked at each time
  std::array<Triple<double>, carried_places> orbital_m_s{};
  std::array<Triple<double>, carried_places> orbital_m_s2{};
  Triple<double> current_m_s;  ///< at the vehicle
  Triple<double> shear_per_s;
  double elevation_m = 0;  ///< of the surface over the vehicle
  double rise_m_s = 0;     ///< of that
};

/// Water that is looked up now and then where places will be, and carried from look to look: the
/// orbital velocity and the surface by the cubic that has both values and both slopes (Hermite),
/// the current in a straight line. Numbers only: they are copied into a checkpoint and back.
struct CarriedWater {
  double looks = 0;  ///< made; 0: nothing is known yet
  double holds = 0;  ///< 1, or 0 where the vehicle had no water at one of both looks
  double to_s = 0;   ///< until when: that of the vehicle, the nodes' is not earlier
  WaterLook before;
  WaterLook after;
  /// At the nodes; an eighth of them is looked at anew each time.
  std::array<Triple<double>, tether_inner_nodes> node_current_m_s{};
};

/// Looks at the water of `t_s + ahead_s`, where the places will then be as they move now; the first
/// time also at that of `t_s`. Where there is no water a node has none, and the vehicle's does not
/// hold. No allocation.
///
/// Error of the orbital velocity, for a wave of angular frequency w: (w h)^4/384 of it for h =
/// `ahead_s`, 0.01 % for 4 s and 0.3 s; waves of a second it cannot follow. Nodes at a depth z,
/// where waves have decayed by exp(-w^2 z/g), are looked at for 2, 4 or 8 times as long ahead,
/// h, where no wave errs by more than 0.14 % of its motion at the surface for that: from
/// w^2 = 2 g/z, which errs most, z > 10 m/s^2 h^2. A place that gains speed on the way is some
/// centimetres from where it was looked for.
void look_ahead(const EnvironmentSampler& water, const MovingPlaces& places, double t_s,
                double ahead_s, CarriedWater& carried);

/// The water of the vehicle at a time between the looks, where it holds.
[[nodiscard]] WaterSample vehicle_water(const CarriedWater& carried, double t_s) noexcept;
/// That at the nodes of its tether.
[[nodiscard]] WaterAtNodes<double> node_water(const CarriedWater& carried, double t_s) noexcept;

}  // namespace slackwater::twin
