#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "twin/risk/bound.h"
#include "twin/risk/start_steps.h"
#include "twin/risk/workability/step_range.h"
#include "twin/risk/workability/task_history.h"

namespace slackwater::twin {

/// One limit of a task at one place, over the steps of the grid.
struct WatchedLimit {
  std::size_t limit = 0;  ///< which of the task's limits; several places may be watched for one
  Bound bound;
  bool may_be_missing = false;  ///< a value that nobody knows is let pass; else it is none
  bool is_gate = false;    ///< how near it is says nothing: daylight, a shift, a level of the sea
  StepRanges when;         ///< steps after that of the start at which it counts
  std::size_t before = 0;  ///< steps before the start from which `when` counts instead
  /// Values by member, member 0 the central one; a single one: the same in all. A value is that of
  /// the whole step, the worst of it.
  std::vector<std::span<const double>> members;
  /// The share of the bound up to which the central forecast may come, by start; NaN: no practice
  /// says one. Empty: the whole bound.
  std::vector<double> alpha{};
};

/// Work that may be done over several visits.
struct SplitWork {
  std::size_t work = 1;  ///< steps of it
  TaskHistory::Visits visits;
  std::size_t by_step = 0;  ///< of the grid: when it has to be done
  std::size_t limit = 0;    ///< what stops a start where time alone is too short
};

/// A task, held against a forecast.
struct StartQuestion {
  std::size_t steps = 0;    ///< of the grid
  std::size_t members = 1;  ///< the central one among them
  std::size_t limits = 0;   ///< how many the task has
  StartSteps starts;
  std::vector<WatchedLimit> watched;
  std::optional<SplitWork> split{};  ///< absent: it is done in one go
};

/// The limit that a start comes up against first.
struct BindingLimit {
  std::size_t limit = 0;
  bool is_exceeded = false;  ///< in a member at least; else it is the one nearest to its bound
  std::size_t members = 0;   ///< that it is the first to stop
  /// Of the grid: when it is exceeded, the median of those members; else when the central forecast
  /// comes nearest.
  std::size_t step = 0;
  /// What the central forecast takes up of it, at most, while it counts: above 1 it is exceeded.
  /// NaN where nobody knows, and of a gate.
  double share = 0;
};

/// What a start may hope for.
struct StartChance {
  bool by_threshold = false;     ///< the central forecast keeps all limits
  std::optional<bool> by_alpha;  ///< and with the margins of practice; absent: it says nothing
  std::size_t held = 0;          ///< members that keep all limits
  std::optional<BindingLimit> binding;  ///< absent: it has no limit that says how near it is
};

/// Holds the limits of a task against all members, for every start.
///
/// A member keeps a start if at each step at which a limit counts its value is within the bound.
/// From the end of a series backwards the next step that is not is noted for each step, so that a
/// start asks once for each stretch at which a limit counts: time proportional to
/// (steps + starts) x watched limits x members, whatever the task's length.
///
/// Split work is kept from a start if a visit can begin then, and the visits from then on come to
/// all of it in time; every limit counts at every step of a visit, whatever phases it names, and
/// `when` says for how long after the start it is asked how near a limit is. None is watched from
/// before the start.
///
/// @throws ContractViolation for series that are shorter than the grid, and starts from which a
///         limit counts beyond it
/// Thread-safe. Source: twin/docs/operations.md, sections 3 and 4.
[[nodiscard]] std::vector<StartChance> start_chances(const StartQuestion& question);

}  // namespace slackwater::twin
