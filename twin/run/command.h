#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fields/base/boxed.h"
#include "twin/body/actuator_values.h"
#include "twin/environment/weather_in_hand.h"
#include "twin/run/newcomer.h"

namespace slackwater::twin {

// What may be done to a vehicle from outside. But for `PutVehicle`, `HostPhysics`, `Resume`,
// `PointCamera` and `Spawn` each puts it under the helm (`HelmState`): its own mission and
// behaviour tree stand still until `Resume`. The latest one is in force. `SetWeather` is done to
// the run.

/// Waypoints, from where the vehicle takes itself to be; at the last of them it holds, and the list
/// is done (`HelmCause::list_done`). None: it stays where it is.
struct Reroute {
  std::vector<Waypoint> waypoints;  ///< NED
  bool loop = false;                ///< after the last goes on with the first; from two on
};

/// A velocity through the water. Renewed within `HelmRule::renewal_s`, or the vehicle holds.
struct SetVelocity {
  HelmVelocity velocity;
};

/// The thrusters themselves, in the order of the vehicle's file, -1 to 1; renewed likewise.
///
/// | kind      | 1 is                          | -1 is                | between              |
/// |-----------|-------------------------------|----------------------|----------------------|
/// | table     | the command 1 of its table    | the command -1       | the command          |
/// | propeller | its largest speed of shaft    | the same astern      | that share of it     |
/// | rotor     | its largest speed             | none: as 0, it stands| that share of it     |
/// | drive     | its largest thrust            | its largest astern   | that share of thrust |
///
/// Fins stand amidships; a moving mass and a bladder stay as they are. What swims and has come out
/// of the water pushes nothing. An empty battery and a lost thruster stop them all the same;
/// neither clearance nor limits look at them.
struct SetThrusters {
  std::vector<double> share;
};

/// Thrusters, fins and ballast by their channels (twin/vehicle/actuator_channels.h), each as a
/// share of its range, -1 to 1, or in its own unit. Renewed, stopped and looked at as
/// `SetThrusters`. Thrusters that are not named stand still and fins amidships; a moving mass and a
/// bladder that are not named stay as they are.
struct SetActuators {
  ActuatorValues given;
  bool is_physical = false;  ///< else shares
};

/// Keep this place: where the vehicle takes itself to be. Craft that cannot stand still circle it.
struct HoldHere {
  bool is_client_lost = false;  ///< for want of a helm: the way home follows (`HelmRule`)
};

/// Go home: as its conduct has it, else round the structures to where it began.
struct GoHome {};

/// Back to its own mission, where that was left.
struct Resume {};

/// The vehicle put elsewhere, or in other motion. Its mission, its tether and what its instruments
/// told it stay as they were. Of one whose physics are hosted: what those made of the step, put at
/// the end of it.
struct PutVehicle {
  Boxed<VehicleState<double>> vehicle;
};

/// Whether the vehicle's physics are made elsewhere, and come by `PutVehicle`; see
/// `Run::host_physics`. Back from there it goes on from where it was put last.
struct HostPhysics {
  bool is_hosted = true;
};

/// A vehicle that joins the run, behind those that are there; `Command::agent` is its place from
/// then on, whatever it was before. Of a record the newcomer alone is kept, and it is made ready
/// again for the time at which the command came in (`Command::received_s`).
struct Spawn {
  Newcomer newcomer;
  std::shared_ptr<const ReadyNewcomer> ready;
};

/// Where its camera looks and how much it shows; whoever has the helm has the camera, whatever the
/// vehicle does meanwhile.
struct PointCamera {
  CameraPointing pointing;
};

/// The weather of all vehicles of the run; `Command::agent` is 0.
struct SetWeather {
  WeatherAsked asked;
};

using CommandWhat = std::variant<Reroute, PutVehicle, SetVelocity, SetThrusters, HoldHere, GoHome,
                                 Resume, HostPhysics, Spawn, PointCamera, SetWeather, SetActuators>;

/// What is done to a vehicle from outside while a run goes on. A value: the list of those that a
/// run took makes the run again.
struct Command {
  /// Takes effect before this step is made; once that is past, before the next one.
  std::uint64_t step = 0;
  std::size_t agent = 0;
  CommandWhat what{};
  std::string source{};        ///< which door and which client, e.g. "dds 01.0f.ab"
  std::uint64_t sequence = 0;  ///< the source's own count for this vehicle
  double received_s = 0;       ///< run time when it came in
};

/// "waypoints", "velocity", ...: by the kind of what is done.
[[nodiscard]] std::string_view name_of(const CommandWhat& what) noexcept;

/// Whether it leads a vehicle elsewhere, or holds it, when its energy may be needed for its way
/// home.
[[nodiscard]] bool leads_elsewhere(const CommandWhat& what) noexcept;

/// Whether it is in force only while it is renewed, within `HelmRule::renewal_s`.
[[nodiscard]] bool must_be_renewed(const CommandWhat& what) noexcept;

/// What of its numbers no vehicle can follow: waypoints, velocities, thrusters or actuators that
/// are not finite, beyond their range, of another number than the vehicle's or not of it, a camera
/// beyond its joints. Empty: nothing, as for a vehicle that joins, which was looked at when it was
/// made ready, and for the weather, which is looked at with its environment.
[[nodiscard]] std::string_view unsoundness_of(const Command& command, const Agent& agent) noexcept;

/// A vehicle that has halted, or stands on a deck, stays as it is; one whose energy is needed for
/// its way home is not led elsewhere.
/// @param t_s  of the step before which it takes effect
void apply(const Command& command, double t_s, const Agent& agent, AgentState& state);

}  // namespace slackwater::twin
