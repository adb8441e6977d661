#pragma once
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/account/closest.h"
#include "twin/account/fate.h"
#include "twin/account/manoeuvre_account.h"
#include "twin/account/mission_event.h"
#include "twin/account/track_account.h"
#include "twin/agent/agent.h"
#include "twin/clearance/clear_way.h"
#include "twin/inspection/inspection_outcome.h"
#include "twin/risk/risk_cause.h"
#include "twin/scenario/scenario.h"
#include "twin/surface/cleaning_outcome.h"

namespace slackwater::twin {

/// What a vehicle has on board, as far as an account goes by it.
struct Makeup {
  bool has_battery = false;
  bool is_electric = false;  ///< something on board draws from a bus
  bool burns_fuel = false;
  bool floats = false;  ///< it has no depth to keep
  bool flies = false;
  bool by_sensors = false;   ///< else its autopilot is told the truth
  bool has_conduct = false;  ///< it conducts itself
  bool searches = false;     ///< for somebody
  friend bool operator==(const Makeup&, const Makeup&) = default;
};

/// What came of keeping clear.
struct ClearanceAccount {
  std::array<double, alarm_causes> alarms_from{};  ///< by `AlarmCause`
  double changed_s = 0;  ///< for how long in all it was made to do otherwise
  [[nodiscard]] double alarms() const noexcept;
  friend bool operator==(const ClearanceAccount&, const ClearanceAccount&) = default;
};

/// What became of one vehicle of a run: the one account that rehearsals, pages, scorecards and
/// tables are made from, and that a log keeps (api/log/account_log.h).
struct VehicleAccount {
  std::string name;
  std::string model;  ///< of the catalogue
  Makeup makeup;

  // What befell it.
  std::vector<FateEvent> fate;  ///< causes first; none: a normal run
  Halt halt = Halt::none;
  double halted_at_s = 0;

  // What it did.
  std::vector<MissionEvent> mission;  ///< of one that conducts itself
  bool is_done = false;        ///< its mission, home again, with its reserve; without one: no halt.
                               ///< What it saw is another matter: `is_seen`
  std::string stopped_by;      ///< in words, the same for the same cause; empty: nothing
  bool broke_reserve = false;  ///< it came home with less than its reserve
  double ended_s = 0;          ///< since the start; of what did not end, the end of the run
  double held_s = 0;
  std::size_t tasks = 0;
  std::size_t tasks_done = 0;
  std::size_t waypoints = 0;
  std::optional<double> found_s;  ///< when it found whom it searches for

  // With what margins.
  Spent in_all;                 ///< until the end of the run
  Spent on_mission;             ///< until its mission ended
  double least_charge = 1;      ///< of its battery
  double worst_share = 0;       ///< of any limit while it was at its task; above 1 it was exceeded
  double thrust_used = 0;       ///< at most, of what its thrusters can (`ThrustUse`)
  double line_used = 0;         ///< at most, of what its tether bears; 0: it has none
  double largest_roll_rad = 0;  ///< of its size, over all steps
  double largest_pitch_rad = 0;
  Closest closest;
  std::optional<ClearanceAccount> clearance;  ///< of one that keeps clear

  // With what result.
  std::optional<CleaningOutcome> cleaning;      ///< of one that cleans
  std::optional<InspectionOutcome> inspection;  ///< of one that inspects
  std::vector<ManoeuvreAccount> manoeuvres;     ///< of its tasks, in their order

  // At the times of its log; as they are by default where no log is kept (`rehearse`).
  TrackAccount track;    ///< until it halted
  TrackAccount at_work;  ///< until its mission ended

  /// Whether its inspection covered what is asked of it; nothing where nothing is asked.
  [[nodiscard]] std::optional<bool> is_seen() const noexcept;
  /// Of its tasks that are done; 1 of none.
  [[nodiscard]] double work_share() const noexcept;
  /// "battery empty at ... -> fell -> ..."; empty for a normal run. A structure that it struck is
  /// named: the one that it came nearest to.
  [[nodiscard]] std::string fate_text(UtcTime start) const;
  /// What befell it, as a register of risks has it.
  [[nodiscard]] RiskCauses risks() const;
  friend bool operator==(const VehicleAccount&, const VehicleAccount&) = default;
};

/// A run, or a flight of several in one, that is over.
struct EndedRun {
  std::span<const Agent> agents;
  std::span<const AgentState> states;
  std::span<const ScenarioStructure> structures;
  double ran_s = 0;  ///< how long it was
};

/// All but what the rows of a log tell.
[[nodiscard]] VehicleAccount account_of(const EndedRun& run, std::size_t vehicle);
/// What they tell: `track`, `at_work` and the figures of manoeuvres.
void add_rows(const VehicleRows& rows, VehicleAccount& account);

/// What became of all of them.
struct RunAccount {
  UtcTime start;
  double ran_s = 0;
  std::vector<VehicleAccount> vehicles;
  friend bool operator==(const RunAccount&, const RunAccount&) = default;
};

}  // namespace slackwater::twin
