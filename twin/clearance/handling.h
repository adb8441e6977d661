#pragma once
#include "twin/clearance/planar.h"

namespace slackwater::twin {

/// How a vehicle gets out of trouble.
enum class Manner {
  pushes,   ///< stops, and goes off any way: ROVs, multirotors
  turns,    ///< stops straight ahead, and must turn before it goes off: surface craft
  circles,  ///< cannot stop and steer: AUVs circle to starboard
};

/// What a vehicle promises of itself. The bounds of `clear_way` hold for one that keeps it.
struct Handling {
  Manner manner = Manner::pushes;
  double deceleration_m_s2 = 0;  ///< told to stop it loses speed at least this fast
  double acceleration_m_s2 = 0;  ///< its velocity changes no faster than this
  /// Told to stop, it goes on for at most this long as if nobody had said so: the lag of loops and
  /// thrusters and a step of the barrier.
  double reaction_s = 0;
  /// Until it slows down its claim goes on ahead of it. Motions are planned for a reaction slower
  /// by this share, so that it slows down before it must stop.
  double early = 0.25;
  double stray_m = 0;  ///< beside its way by no more than this, whatever pushes it: gusts, swell
  double most_speed_m_s = 0;
  double sure_speed_m_s = 0;  ///< over ground, any way, in any current that the promise is for
  double most_yaw_rate_rad_s = 0;
  double turning_radius_m = 0;  ///< `circles`: of the circle that is always open to it
  double vertical_deceleration_m_s2 = 0;
  /// The upright cylinder that it fills, about its origin; afloat about the still-water level, as
  /// heave is no choice of its own.
  double radius_m = 0;
  double above_m = 0;
  double below_m = 0;
  bool is_afloat = false;
};

/// How far it goes from the moment that it is told to stop: v (t_r + v/(2 a)).
[[nodiscard]] inline double stopping_way_m(const Handling& h, double speed_m_s) noexcept {
  return speed_m_s * (h.reaction_s + speed_m_s / (2 * h.deceleration_m_s2));
}
/// The speed whose stopping way, with `more_s` of reaction, is that long.
[[nodiscard]] inline double speed_for_way_m_s(const Handling& h, double way_m,
                                              double more_s) noexcept {
  const double a = h.deceleration_m_s2, t = h.reaction_s + more_s;
  return a * (std::sqrt(t * t + 2 * std::max(way_m, 0.0) / a) - t);
}

/// Where a vehicle is and how it moves, over ground, NED.
struct OwnMotion {
  Planar position_m;
  Planar velocity_m_s;
  double depth_m = 0;  ///< z
  double down_m_s = 0;
  Planar bow{1, 0};  ///< unit vector
};

/// Where a vehicle stays, come what may: the places nearer than the radius to a stretch, between
/// two depths. A set that it need not leave.
struct Claim {
  Stretch stretch;
  double radius_m = 0;
  double top_m = 0;  ///< z
  double bottom_m = 0;
};

/// The claim of a motion. One that stops: its stopping way. One that circles: the circle to
/// starboard of the bow, wherever it begins within the reaction: the same as long as it circles. In
/// depth: its stopping way down or up.
[[nodiscard]] Claim claim_of(const Handling& handling, const OwnMotion& own) noexcept;

}  // namespace slackwater::twin
