#pragma once
#include <cstdint>
#include <limits>
#include <vector>

#include "fields/base/numbers/random.h"
#include "twin/mission/deck_motion.h"
#include "twin/mission/phase.h"
#include "twin/mission/tick.h"
#include "twin/search/datum.h"
#include "twin/search/noisy_work.h"
#include "twin/search/person_search.h"
#include "twin/state/mission.h"
#include "twin/surface/cleaning.h"

namespace slackwater::twin {

/// What a vehicle that conducts itself is doing.
enum class Doing : std::uint8_t {
  task,
  hold,
  way_back,  ///< to the place where it left its task
  way_home,
};

/// What happened to it, and when.
enum class ConductEventKind : std::uint8_t {
  phase_began,      ///< `detail`: which
  hold_began,       ///< `cause`
  went_back,        ///< to where it left its task
  resumed,          ///< its task
  turned_for_home,  ///< `cause`
  came_home,        ///< by that way
  came_aboard,
  launched,
  fault_began,  ///< `detail`: which of the plan's
  fault_ended,
  finished,  ///< all its tasks
  gave_up,   ///< its tree had nothing left to do
  found,     ///< whom it looks out for; `value`: from how far, m
};
[[nodiscard]] const char* name_of(ConductEventKind kind) noexcept;

/// Why a vehicle is not at its task: the condition of its tree that did not hold.
enum class Cause : std::uint8_t {
  none,
  limit,
  reserve,
  link,
  gnss,
  thruster,
  tether,
  held_too_long,
  carrier,   ///< has turned for home, or goes no further
  mammal,    ///< seen in the zone about its work
  no_watch,  ///< nobody has watched that zone for long enough
};
[[nodiscard]] const char* name_of(Cause cause) noexcept;

struct ConductEvent {
  double t_s = 0;  ///< since the epoch
  ConductEventKind kind{};
  Cause cause = Cause::none;
  std::size_t detail = 0;  ///< of a cause `limit`: which of the plan's
  double value = 0;        ///< of that limit's variable then
};

/// What a mission has taken. Numbers only: they are copied into a checkpoint and back.
struct Spent {
  double drawn_j = 0;  ///< electrical
  double fuel_kg = 0;
  double charge = 1;  ///< of the battery, left
  friend bool operator==(const Spent&, const Spent&) = default;
};

/// How far a vehicle that conducts itself has come.
struct ConductState {
  static constexpr std::size_t no_structure = std::numeric_limits<std::size_t>::max();
  BehaviourState tree;
  Doing doing = Doing::task;
  MissionState way;       ///< of a hold, the way back and the way home
  Triple<double> left_m;  ///< where its task is taken up again, in the frame of that
  Phase phase = Phase::transit;
  Cause cause = Cause::none;  ///< of what it does instead of its task
  std::size_t cause_detail = 0;
  double cause_value = 0;
  std::vector<double> exceeded_s;    ///< of each limit: when it was exceeded last; -inf: never
  std::vector<std::uint8_t> faults;  ///< of each: whether it was on at the last tick
  double extra_power_w = 0;  ///< drawn beyond what its speed takes: waves, gusts, a line; smoothed
  double drawn_j = 0;        ///< as of the last tick
  std::size_t worked_at = no_structure;  ///< by its place in the environment
  double wound_rad = 0;                  ///< round that structure, clockwise from above
  double bearing_rad = 0;                ///< from that structure's axis, at the last tick
  DeckMotion deck;
  double energy_left_j = std::numeric_limits<double>::infinity();  ///< as of the last tick
  double energy_home_j = 0;   ///< what the way home takes by reckoning, without margin and reserve
  double held_s = 0;          ///< in all
  double least_charge = 1;    ///< of its battery, at a tick
  double most_share = 0;      ///< of any limit, while it worked
  Triple<double> boarding_m;  ///< where it comes aboard: at its carrier's, or home
  Triple<double> snag_m;      ///< where a fouled line is caught
  std::size_t snag_node = 0;  ///< of the line's inner nodes; meaningless where it is free
  Triple<double> aim_m;       ///< how far off the plan the pilot aims
  Rng pilot_rng{0, ""};
  Spent at_end;             ///< once it has ended: what comes then is no part of the mission
  bool has_ended = false;   ///< its tree: nothing more comes
  bool has_turned = false;  ///< for home, before its tasks were done
  bool is_snagged = false;
  bool waits_for_line = false;  ///< turned for home, it does not set out with one in the water
  bool is_aboard = false;       ///< its carrier, or at home on something firm: it is not stepped
  SearchState search;
  DatumState datum;          ///< of a search that follows the drift
  Triple<double> frame_m_s;  ///< velocity of the frame that its autopilot goes by
  MammalDutyState mammals;
  NoisyWorkState noisy;
  CleaningState cleaning;
  std::vector<ConductEvent> events;
};

}  // namespace slackwater::twin
