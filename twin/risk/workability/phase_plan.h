#pragma once
#include <vector>

#include "twin/mission/phase.h"
#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// A stretch of a task that is planned.
struct PlannedPhase {
  Phase phase = Phase::work;
  double duration_s = 0;
};

/// A task as it is planned for one worker: its phases one after the other from the start on. A
/// phase may come more than once.
struct PhasePlan {
  std::vector<PlannedPhase> phases;
  [[nodiscard]] double duration_s() const noexcept;
};

/// The same with its work drawn out, all of it alike, so that the whole takes at least so long; a
/// plan without work has it at its end.
[[nodiscard]] PhasePlan stretched(PhasePlan plan, double duration_s);

/// The steps after that of the start which some phases may touch. The task may fall behind by up to
/// the contingency at any time, so that each phase counts from when it begins at the earliest until
/// it ends at the latest. A step counts whole where a phase touches a part of it.
/// @param phases         which
/// @param contingency_s  0 and more
/// @param step_s         of the grid, more than 0
[[nodiscard]] StepRanges steps_of(const PhasePlan& plan, PhaseSet phases, double contingency_s,
                                  double step_s);

}  // namespace slackwater::twin
