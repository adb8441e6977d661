#include "twin/state/helm_rule.h"

namespace slackwater::twin {

const char* name_of(HelmMode mode) noexcept {
  switch (mode) {
    case HelmMode::own:
      return "own";
    case HelmMode::waypoints:
      return "waypoints";
    case HelmMode::velocity:
      return "velocity";
    case HelmMode::thrusters:
      return "thrusters";
    case HelmMode::hold:
      return "hold";
    case HelmMode::home:
      return "home";
    case HelmMode::actuators:
      return "actuators";
  }
  return "unknown";
}

const char* name_of(HelmCause cause) noexcept {
  switch (cause) {
    case HelmCause::none:
      return "none";
    case HelmCause::asked:
      return "asked";
    case HelmCause::list_done:
      return "list_done";
    case HelmCause::not_renewed:
      return "not_renewed";
    case HelmCause::client_lost:
      return "client_lost";
    case HelmCause::held_too_long:
      return "held_too_long";
    case HelmCause::reserve:
      return "reserve";
  }
  return "unknown";
}

HelmDue helm_due(const HelmRule& rule, HelmMode mode, HelmCause cause, double since_s,
                 double renewed_s, double now_s) noexcept {
  constexpr double soon_s = 1e-6;  // what rounding leaves of a number of steps
  switch (mode) {
    case HelmMode::velocity:
    case HelmMode::thrusters:
    case HelmMode::actuators:
      if (now_s - renewed_s >= rule.renewal_s - soon_s)
        return {HelmMode::hold, HelmCause::not_renewed};
      break;
    case HelmMode::hold: {
      const bool is_for_want_of_helm =
          cause == HelmCause::not_renewed || cause == HelmCause::client_lost;
      if (is_for_want_of_helm && rule.home_after_s > 0 &&
          now_s - since_s >= rule.home_after_s - soon_s)
        return {HelmMode::home, HelmCause::held_too_long};
      break;
    }
    case HelmMode::own:
    case HelmMode::waypoints:
    case HelmMode::home:
      break;
  }
  return {mode, cause};
}

}  // namespace slackwater::twin
