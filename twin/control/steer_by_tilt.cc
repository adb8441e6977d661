#include "twin/control/control_laws.h"

namespace slackwater::twin {
namespace {

/// Of the rotors' thrust, so that there is always some left to tilt with, either way. PX4:
/// MPC_THR_MIN 0.12, MPC_THR_MAX 1.
constexpr double least_collective = 0.12;
constexpr double most_collective = 0.9;
/// PX4: MC_ROLLRATE_MAX, 220 degrees/s.
constexpr double most_tilt_rate_rad_s = 3.84;

/// Thrust over ground, N: north, east and up.
struct Lift {
  double north = 0;
  double east = 0;
  double up = 0;
  double share = 1;     ///< of the horizontal thrust that was asked for
  double up_share = 1;  ///< 1, or 0 where the height asks for what there is not
};

/// The height first: then as much to the side as the tilt and the thrust allow.
Lift bounded_lift(const Autopilot& a, const Triple<double>& acceleration_m_s2) noexcept {
  const double mass_kg = a.weight_n / constants::gravity_m_s2;
  const double most = most_collective * a.allocation.most_astern[2];
  const double least = least_collective * a.allocation.most_astern[2];
  const double up = a.weight_n - mass_kg * acceleration_m_s2.z;
  Lift lift{mass_kg * acceleration_m_s2.x, mass_kg * acceleration_m_s2.y,
            std::clamp(up, least, most)};
  lift.up_share = lift.up == up ? 1.0 : 0.0;
  const double size = std::sqrt(lift.north * lift.north + lift.east * lift.east);
  const double room = std::min(lift.up * a.tan_most_tilt,
                               std::sqrt(std::max(most * most - lift.up * lift.up, 0.0)));
  if (size > room) {
    lift.share = room / size;
    lift.north *= lift.share;
    lift.east *= lift.share;
  }
  return lift;
}

}  // namespace

Effort steer_by_tilt(const Autopilot& a, const Measured& measured, const Reference& reference,
                     const Outset& outset, double dt_s, ControlState& state) noexcept {
  const Rotation<double>& r = outset.r;
  const Triple<double>& rate = measured.nu.angular;
  const Triple<double> wanted =
      eased_velocity(a, wanted_velocity(a, measured, reference, outset), dt_s, state);
  const Triple<double> lacking = wanted - outset.velocity_m_s;
  const Triple<double> push{acceleration_of(a.horizontal, lacking.x, state.north_m_s2),
                            acceleration_of(a.horizontal, lacking.y, state.east_m_s2),
                            acceleration_of(a.vertical, lacking.z, state.down_m_s2)};
  const Lift lift = bounded_lift(a, push);

  // The body's down axis is to point against the thrust that is wanted: z_d, seen from the body.
  const double thrust =
      std::sqrt(lift.north * lift.north + lift.east * lift.east + lift.up * lift.up);
  const Triple<double> z = r.to_body({-lift.north / thrust, -lift.east / thrust, lift.up / thrust});
  double roll = -z.y, pitch = z.x;
  const double sine = std::sqrt(roll * roll + pitch * pitch);
  if (z.z < 0) {  // more than a right angle: all the way
    roll = sine > 1e-6 ? roll / sine : 1.0;
    pitch = sine > 1e-6 ? pitch / sine : 0.0;
  }
  const auto tilt_rate = [&](double error) {
    return std::clamp(a.tilt.outer_per_s * error, -most_tilt_rate_rad_s, most_tilt_rate_rad_s);
  };
  const double most_turn = a.settings.most_yaw_rate_rad_s;
  const Triple<double> turning{
      tilt_rate(roll) - rate.x, tilt_rate(pitch) - rate.y,
      std::clamp(a.heading.outer_per_s * turn_rad(outset.bow, reference.heading), -most_turn,
                 most_turn) -
          rate.z};
  const Triple<double> twist{acceleration_of(a.tilt, turning.x, state.roll_rad_s2),
                             acceleration_of(a.tilt, turning.y, state.pitch_rad_s2),
                             acceleration_of(a.heading, turning.z, state.yaw_rad_s2)};
  // As much along the rotors as the wanted thrust has along them now.
  const double along = lift.up * r.down.z - lift.north * r.north.z - lift.east * r.east.z;
  const double rotors_n = a.allocation.most_astern[2];
  const double collective =
      std::clamp(along, least_collective * rotors_n, most_collective * rotors_n);
  const auto& m = a.mass.entry;
  const Thrusts thrusts =
      allocate(a.allocation,
               {{0, 0, -collective}, {m[3][3] * twist.x, m[4][4] * twist.y, m[5][5] * twist.z}});

  integrate(a.horizontal, lacking.x, push.x, lift.share, dt_s, state.north_m_s2);
  integrate(a.horizontal, lacking.y, push.y, lift.share, dt_s, state.east_m_s2);
  integrate(a.vertical, lacking.z, push.z, lift.up_share, dt_s, state.down_m_s2);
  integrate(a.tilt, turning.x, twist.x, thrusts.share[3], dt_s, state.roll_rad_s2);
  integrate(a.tilt, turning.y, twist.y, thrusts.share[4], dt_s, state.pitch_rad_s2);
  integrate(a.heading, turning.z, twist.z, thrusts.share[5], dt_s, state.yaw_rad_s2);
  Effort effort;
  effort.thrust_n = thrusts.thrust_n;
  return effort;
}

}  // namespace slackwater::twin
