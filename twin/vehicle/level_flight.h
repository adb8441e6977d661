#pragma once
#include "twin/vehicle/vehicle.h"

namespace slackwater::twin {

/// A way of an AUV through still water, straight and at one depth: its bow so far up or down that
/// its hull bears what its ballast leaves, its elevator and its moving mass so that it stays there.
struct LevelFlight {
  double pitch_rad = 0;     ///< of the bow, up
  double elevator_rad = 0;  ///< bow up; what it takes, were there no limit to it
  double borne_n = 0;       ///< net buoyancy that hull and fins hold down so
  bool is_held = false;     ///< within what the elevator has and before it stalls
};

/// That with the water along the hull at `speed_m_s` and from above at `down_m_s` (w, that of a bow
/// up is positive): with w = u tan(pitch) and no turning,
///
///   M_hull + M_fin(elevator) + M_righting + M_mass = 0,  borne cos(pitch) = Z_hull + Z_fin
///
/// by all that the body's equations have: damping, lift with the speed, strips of the cross-flow,
/// the moment of the added mass. Source: Fossen (2021), 6.4-6.5 and 9.4.
[[nodiscard]] LevelFlight level_flight_at(const Vehicle& vehicle, double speed_m_s,
                                          double down_m_s);

/// The least pitched way at a speed that bears that much net buoyancy (below 0: weight), whether
/// its elevator holds it or not, up to its steepest pitch; its autopilot makes up for no more
/// sinking than three tenths of its most speed. Where none does: the strongest.
[[nodiscard]] LevelFlight level_flight(const Vehicle& vehicle, double speed_m_s,
                                       double net_buoyancy_n);

/// The one that its elevator holds and that bears most.
/// @param way  above 0: of buoyancy; below: of weight
[[nodiscard]] LevelFlight strongest_level_flight(const Vehicle& vehicle, double speed_m_s,
                                                 double way);

}  // namespace slackwater::twin
