#pragma once
#include <cstdint>

namespace slackwater::twin {

/// Who says what a vehicle does, and what that is.
enum class HelmMode : std::uint8_t {
  own,        ///< its own mission, and its behaviour tree where it has one
  waypoints,  ///< a list, until it is done
  velocity,   ///< through the water, while it is renewed
  thrusters,  ///< raw, while it is renewed
  hold,       ///< a place
  home,       ///< on the way there, and there
  actuators,  ///< thrusters, fins and ballast, while it is renewed
};
[[nodiscard]] const char* name_of(HelmMode mode) noexcept;

/// Why a vehicle is in its mode.
enum class HelmCause : std::uint8_t {
  none,
  asked,          ///< by a command
  list_done,      ///< a hold at the last waypoint
  not_renewed,    ///< a hold, as velocity, thrusters or actuators were not renewed in time
  client_lost,    ///< a hold, as whoever was at the helm is gone
  held_too_long,  ///< on its way home, as nobody came after one of these two holds
  reserve,        ///< on its way home, as its energy is needed for that
};
[[nodiscard]] const char* name_of(HelmCause cause) noexcept;

/// Whether its thrusters and fins are driven by hand.
[[nodiscard]] constexpr bool is_by_hand(HelmMode mode) noexcept {
  return mode == HelmMode::thrusters || mode == HelmMode::actuators;
}
/// Whether it is in force only while it is renewed.
[[nodiscard]] constexpr bool must_be_renewed(HelmMode mode) noexcept {
  return mode == HelmMode::velocity || is_by_hand(mode);
}

/// How long a vehicle goes on without a word from outside.
struct HelmRule {
  double renewal_s = 1;      ///< velocity, thrusters and actuators, since the last of their kind
  double home_after_s = 60;  ///< of a hold for want of a helm; 0: never
};

/// What a vehicle is to be in.
struct HelmDue {
  HelmMode mode = HelmMode::own;
  HelmCause cause = HelmCause::none;
};
/// What time makes of a mode: the same, or a hold after what must be renewed, or the way home after
/// a hold for want of a helm.
///
/// At the opening of a step: what is due at its start, to a microsecond, takes effect before it is
/// made. Pure, so that a run made again has it at the same step.
/// @param since_s, renewed_s  as in `HelmState`
[[nodiscard]] HelmDue helm_due(const HelmRule& rule, HelmMode mode, HelmCause cause, double since_s,
                               double renewed_s, double now_s) noexcept;

}  // namespace slackwater::twin
