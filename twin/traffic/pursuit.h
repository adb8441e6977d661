#pragma once
#include "twin/traffic/track.h"

namespace slackwater::twin {

/// Where to head and how fast, for the autopilots of a vehicle.
struct Heading {
  double yaw_rad = 0;    ///< clockwise from north
  double speed_m_s = 0;  ///< through the water
  double depth_m = 0;
};

/// Follows a track in time: over ground
///
///   v = v_track + k (p_track - p),
///
/// so that the distance dies away as exp(-k t) while no bound is met; through the water less the
/// current, bounded by the speed of the vehicle. Settings that suit a vessel of some metres that
/// reports once a minute.
struct Pursuit {
  double gain_per_s = 0.1;  ///< k
  double most_speed_m_s = 0;
  double still_m_s = 0.05;  ///< slower than this the yaw is left as it is
};

/// @param wanted     where the track is now; must be known
/// @param water_m_s  the current as the vehicle knows it, NED
/// @param yaw_rad    of the vehicle now
[[nodiscard]] Heading pursue(const Pursuit& pursuit, const TrackState& wanted,
                             const Triple<double>& position_m, const Triple<double>& water_m_s,
                             double yaw_rad);

/// Learns what carries the vehicle along and nobody tells it, current and leeway: d, which is added
/// to the water's motion,
///
///   dd/dt = -(k^2/4) (p_track - p),
///
/// so that the distance dies away as (1 + k t/2) exp(-k t/2) instead of staying at U/k. Only while
/// the speed asked for is within its bound and the distance asks for less than half of that, as it
/// then says something of the water: a craft that has fallen behind learns nothing. Never beyond
/// half of the bound.
void learn_drift(const Pursuit& pursuit, const TrackState& wanted, const Triple<double>& position_m,
                 double dt_s, Triple<double>& drift_m_s);

}  // namespace slackwater::twin
