#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "twin/agent/agent.h"
#include "twin/inspection/inspection_state.h"
#include "twin/scenario/scenario.h"

namespace slackwater::twin {

/// A vehicle of a run that inspected.
struct Inspected {
  std::size_t vehicle = 0;  ///< of the scenario
  const Inspection& inspection;
  const InspectionState& state;  ///< at the end
  bool is_in_water = true;
};

/// What to fly again.
struct Resurvey {
  std::optional<Scenario> scenario;  ///< absent: nothing is left
  std::vector<std::string> words;    ///< a line for each vehicle that flies again
};

/// The scenario once more with those vehicles alone that left something uncovered, each with its
/// work laid out anew (`resurvey_way`), its start, launch, way back and recovery as they were.
[[nodiscard]] Resurvey resurvey_of(const Scenario& scenario, std::span<const Structure> structures,
                                   std::span<const Inspected> inspected);

}  // namespace slackwater::twin
