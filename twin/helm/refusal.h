#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "twin/run/command.h"

namespace slackwater::twin {

/// Why a command is not taken.
enum class RefusalReason : std::uint8_t {
  unknown_vehicle,
  unauthorised,  ///< another client is at the helm, or nobody gave it
  stale,         ///< its sequence is not above the last one, or it is too old
  not_finite,
  out_of_range,      ///< a thruster beyond 1, a speed beyond the vehicle's most
  wrong_count,       ///< of thrusters
  too_many,          ///< waypoints, vehicles, commands at once
  no_place,          ///< outside the forecast, on land, below the bed, in a structure
  vehicle_halted,    ///< it goes no further
  vehicle_not_free,  ///< aboard its carrier, or it needs its energy for the way home
  unknown_model,     ///< a newcomer's, not of the catalogue
  bad_name,          ///< a newcomer's: taken, or none
  unreadable,        ///< a message that is none, or asks for what there is not; the last one
};
[[nodiscard]] const char* name_of(RefusalReason reason) noexcept;
/// The reason of that name; nothing for other names.
[[nodiscard]] std::optional<RefusalReason> refusal_reason_of(std::string_view name) noexcept;

/// A command that is not taken, for people: what was found, what is allowed, what to do.
struct Refusal {
  RefusalReason reason{};
  std::string text;
};

/// What of a vehicle changes and has a say in whether a command is taken.
struct Standing {
  Halt halt = Halt::none;
  double halted_at_s = 0;
  bool is_aboard = false;
  bool must_come_home = false;  ///< see `must_come_home` of helm.h
  double energy_left_j = 0;     ///< of one that must
  double energy_home_j = 0;
  HelmMode mode = HelmMode::own;
  HelmCause cause = HelmCause::none;
};

struct RefusalLimits {
  std::size_t most_waypoints = 10000;
  double oldest_s = 1;              ///< of velocity and thrusters, since they came in
  std::size_t most_at_once = 1000;  ///< commands of a vehicle that wait for one step
};

/// What speaks against a command itself, whoever gives it: its numbers, its age, the vehicle, the
/// water at its waypoints. Nothing: nothing does. Pure; thread-safe.
/// @param last_sequence  of the last command of its source that this vehicle took; absent: none yet
/// @param now_s          run time
[[nodiscard]] std::optional<Refusal> refusal_of(const Command& command, const Agent& agent,
                                                const Standing& standing,
                                                std::optional<std::uint64_t> last_sequence,
                                                double now_s, const RefusalLimits& limits = {});

}  // namespace slackwater::twin
