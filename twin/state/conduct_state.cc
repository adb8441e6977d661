#include "twin/state/conduct_state.h"

namespace slackwater::twin {

const char* name_of(ConductEventKind kind) noexcept {
  switch (kind) {
    case ConductEventKind::phase_began:
      return "phase_began";
    case ConductEventKind::hold_began:
      return "hold_began";
    case ConductEventKind::went_back:
      return "went_back";
    case ConductEventKind::resumed:
      return "resumed";
    case ConductEventKind::turned_for_home:
      return "turned_for_home";
    case ConductEventKind::came_home:
      return "came_home";
    case ConductEventKind::came_aboard:
      return "came_aboard";
    case ConductEventKind::launched:
      return "launched";
    case ConductEventKind::fault_began:
      return "fault_began";
    case ConductEventKind::fault_ended:
      return "fault_ended";
    case ConductEventKind::finished:
      return "finished";
    case ConductEventKind::gave_up:
      return "gave_up";
    case ConductEventKind::found:
      return "found";
  }
  return "unknown";
}

const char* name_of(Cause cause) noexcept {
  switch (cause) {
    case Cause::none:
      return "none";
    case Cause::limit:
      return "limit";
    case Cause::reserve:
      return "reserve";
    case Cause::link:
      return "lost_link";
    case Cause::gnss:
      return "lost_gnss";
    case Cause::thruster:
      return "lost_thruster";
    case Cause::tether:
      return "fouled_tether";
    case Cause::held_too_long:
      return "held_too_long";
    case Cause::carrier:
      return "carrier_gone";
    case Cause::mammal:
      return "marine_mammal";
    case Cause::no_watch:
      return "unwatched_zone";
  }
  return "unknown";
}

}  // namespace slackwater::twin
