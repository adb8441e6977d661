#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/state/conduct_state.h"

namespace slackwater::twin {

struct Agent;

/// Something that a vehicle which conducts itself did.
struct MissionEvent {
  double t_s = 0;  ///< since the start of the run
  ConductEventKind kind{};
  Cause cause = Cause::none;      ///< why it left its task
  std::string text;               ///< "holds: limit: current at most 0.5 m/s, found 0.62"
  std::optional<double> value{};  ///< of a limit: its variable's, then; of one found: how far, m
  friend bool operator==(const MissionEvent&, const MissionEvent&) = default;
};

/// All of a vehicle, by time; none of one that does not conduct itself.
[[nodiscard]] std::vector<MissionEvent> mission_events_of(const Agent& agent,
                                                          const ConductState& own);

/// A cause in words, without numbers of this run: those of many are counted by it.
/// @param detail  of a cause `limit`: which of the plan's
[[nodiscard]] std::string words_of(const Agent& agent, Cause cause, std::size_t detail);

/// A time through which a vehicle did one thing.
struct MissionStretch {
  double from_s = 0;  ///< since the start of the run
  double to_s = 0;
  std::string phase;  ///< "work"
  std::string doing;  ///< "holds", "goes back", "comes home"; empty: its task
};
/// One after the other, up to its end; none without events. @param ran_s  how long the run was
[[nodiscard]] std::vector<MissionStretch> stretches_of(std::span<const MissionEvent> events,
                                                       double ran_s);

/// How a mission ended.
struct MissionEnd {
  double t_s = 0;
  bool is_done = false;
  std::string why;  ///< of one that is not done: "comes home: limit: ..."
};
/// Nothing without events.
[[nodiscard]] std::optional<MissionEnd> mission_end_of(std::span<const MissionEvent> events,
                                                       double ran_s);

/// Whether they leave a vehicle out when its run ends: its mission has not ended, and it did not
/// come aboard last. False without events.
[[nodiscard]] bool are_out(std::span<const MissionEvent> events) noexcept;

/// How often and how long something called a vehicle away from its task.
struct Interventions {
  std::size_t count = 0;             ///< holds and ways home
  std::size_t limit_violations = 0;  ///< of them, those that a limit called for
  double away_s = 0;                 ///< until its task was resumed
  double longest_away_s = 0;
};
[[nodiscard]] Interventions interventions_of(std::span<const MissionEvent> events, double ran_s);

}  // namespace slackwater::twin
