#pragma once
#include <optional>
#include <string>
#include <vector>

#include "twin/inspection/inspection_outcome.h"
#include "twin/risk/risk_cause.h"
#include "twin/simulate/agent.h"
#include "twin/surface/cleaning_outcome.h"

namespace slackwater::twin {

/// How one vehicle's mission ended.
struct VehicleOutcome {
  std::string name;
  bool is_done = false;    ///< all its tasks, home again, with its reserve
  std::string stopped_by;  ///< in words, the same for the same cause; empty: nothing
  double ended_s = 0;      ///< since the start; of what did not end, the end of the run
  double held_s = 0;
  double work_share = 0;  ///< of its tasks that are done
  double state_of_charge = 1;
  double least_charge = 1;
  double energy_j = 0;  ///< electrical, until it ended
  double fuel_kg = 0;
  double worst_share = 0;  ///< of any limit while it was at its task; above 1 it was exceeded
  bool searches = false;   ///< for somebody
  std::optional<double> found_s;  ///< when it found him
  double thrust_used = 0;         ///< at most, of what its thrusters can (`ThrustUse`)
  double line_used = 0;           ///< at most, of what its tether bears; 0: it has none
  std::optional<double> line_parted_s;
  NearestPasses nearest;                        ///< to what was around it
  std::optional<double> clearance_alarms;       ///< of one that keeps clear
  std::optional<CleaningOutcome> cleaning;      ///< of one that cleans
  std::optional<InspectionOutcome> inspection;  ///< of one that inspects
  RiskCauses risks;                             ///< what befell it
  std::vector<ConductEvent> events;
};

/// As of a run's end, or of the vehicle's own where that was before.
/// @param ran_s  how long the run was
[[nodiscard]] VehicleOutcome outcome_of(const Agent& agent, const AgentState& state, double ran_s);

/// An event in words: "holds: current at most 0.5 m/s, found 0.62".
/// @param agent  whose plan it is of
[[nodiscard]] std::string text_of(const ConductEvent& event, const Agent& agent);

}  // namespace slackwater::twin
