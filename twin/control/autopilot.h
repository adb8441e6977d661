#pragma once
#include <array>
#include <span>

#include "twin/body/body.h"
#include "twin/control/allocation.h"
#include "twin/control/autopilot_settings.h"
#include "twin/control/control_loop.h"

namespace slackwater::twin {

/// The means a vehicle has to move itself.
struct Actuators {
  std::span<const Mount> mounts;
  std::span<const ThrustRange> ranges;
  FinPair rudder{};
  FinPair elevator{};
  Trim trim{};
  double lag_s = 0;  ///< of the thrusters behind what they are asked for
};

/// All that a step of control needs, worked out once.
struct Autopilot {
  VehicleKind kind = VehicleKind::rov;
  AutopilotSettings settings;
  Allocation allocation;
  Loop horizontal;
  Loop vertical;
  Loop heading;
  Loop tilt;
  /// A place is gone for at this rate: the outer one of `horizontal`, or a fifth of the heading's
  /// for craft that must turn towards it first.
  double station_per_s = 0;
  SpatialMatrix mass;         ///< M_RB + M_A
  Triple<double> added_mass;  ///< M_A along x, y, z
  double lag_s = 0;
  Spatial<double> linear_damping;
  Spatial<double> quadratic_damping;
  double straightening_kg_m = 0;  ///< yaw moment per rate and speed: of a trailing edge, or -N_ur
  double weight_n = 0;
  double righting_n_m = 0;  ///< moment per sine of roll or pitch
  double tan_most_tilt = 0;
  /// What they turn it with, per radian and square of the speed; 0: none.
  double rudder_n_m_s2_m2 = 0;
  double elevator_n_m_s2_m2 = 0;
  FinPair rudder;
  FinPair elevator;
  Trim trim;
  double displacement_n_m3 = 0;  ///< weight of displaced fluid per volume
};

/// @throws Error(invalid_input) for a vehicle that this kind of autopilot cannot steer, e.g. a
///         multirotor whose rotors do not lift it
[[nodiscard]] Autopilot plan_autopilot(const AutopilotSettings& settings, VehicleKind kind,
                                       const Body& body, const Actuators& actuators);

/// Radius of the tightest turn of a surface craft that goes at that speed: what its thrusters turn
/// it with, over what holds it straight,
///
///   (N_r + m_t x_t^2 u) r + N_|r|r r^2 = M,
///
/// with m_t and x_t of its trailing edge (or -N_ur of `lift`), at the way that the thrust beside
/// that moment keeps up; or that of the yaw rate it is allowed. A turning hull's drift is left out;
/// it helps: the crew transfer vessel turns within 351 m of 498. Infinite where nothing turns it.
[[nodiscard]] double tightest_turn_m(const Autopilot& autopilot, double speed_m_s) noexcept;

/// Craft that must turn to where they go are driven astern by no more than this of their largest
/// speed.
inline constexpr double most_astern_share = 0.2;

/// Whether a velocity that is asked for is over ground: of what can push every way.
[[nodiscard]] bool goes_by_ground(const Autopilot& autopilot) noexcept;

/// The fastest that a way may be asked for: its own most through the water; over ground twice that,
/// where the water carries it as fast as it goes itself.
[[nodiscard]] double most_over_ground_m_s(const Autopilot& autopilot, bool is_over_ground) noexcept;

/// What a controller remembers from step to step: numbers only, stored and compared as a block of
/// them.
struct ControlState {
  double north_m_s2 = 0;  ///< integrals: accelerations held against what pushes steadily
  double east_m_s2 = 0;
  double down_m_s2 = 0;
  double surge_m_s2 = 0;
  double roll_rad_s2 = 0;
  double pitch_rad_s2 = 0;
  double yaw_rad_s2 = 0;
  double drift_north_m_s = 0;  ///< of a craft that cannot push sideways, from what it is not told
  double drift_east_m_s = 0;
  double dive_m_s = 0;          ///< of an AUV: the sinking that its pitch makes up for
  double wanted_ahead_m_s = 0;  ///< velocities asked for, which change no faster than is allowed
  double wanted_north_m_s = 0;
  double wanted_east_m_s = 0;
  double wanted_down_m_s = 0;
  double kept_north = 0;  ///< the course kept on station; (0, 0): none yet
  double kept_east = 0;
  double trim_n_m = 0;   ///< moment of the moving mass
  double volume_m3 = 0;  ///< of the buoyancy engine
  double is_engaged = 0;
};
static_assert(sizeof(ControlState) == 19 * sizeof(double));

/// What the actuators are to do.
struct Effort {
  std::array<double, most_mounts> thrust_n{};
  double rudder_rad = 0;
  double elevator_rad = 0;
  double moving_mass_m = 0;
  double volume_m3 = 0;
};

/// One step of control, dt_s > 0. Craft that swim by fins or that float go by their speed through
/// the water: by their log, or, without one, by the thrust that this speed takes in still water.
/// What can push every way goes by the ground.
///
/// Always finite and within the actuators' ranges: what is measured and is not a number, or as
/// large as none can be, leaves the state as it was and gives no thrust (a multirotor: its weight).
/// No allocation, no exception.
[[nodiscard]] Effort effort_of(const Autopilot& autopilot, const Measured& measured,
                               const Reference& reference, double dt_s,
                               ControlState& state) noexcept;

}  // namespace slackwater::twin
