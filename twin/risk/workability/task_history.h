#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "twin/risk/workability/step_range.h"

namespace slackwater::twin {

/// When a task would have been done, had it been asked for at any step of a history.
///
/// Whole work waits for the first workable start and is done `work` steps later. Split work goes on
/// in every run of usable steps that is long enough for a visit; each visit loses some steps to
/// getting there and back, and the work is done once as much as is wanted has been done.
class TaskHistory {
 public:
  /// @param starts  workable starts, of a window that holds the work and its contingency
  /// @param work    steps, 1 at least
  [[nodiscard]] static TaskHistory whole(StepRanges starts, std::size_t work);

  struct Visits {
    std::size_t shortest = 1;  ///< steps: no visit is made in a shorter run, or in its shorter rest
    std::size_t lost = 0;      ///< steps of each visit in which no work is done; fewer than those
  };
  /// @param usable  maximal runs of steps at which there may be work
  [[nodiscard]] static TaskHistory split(StepRanges usable, std::size_t work, Visits visits);

  /// When it begins and ends; nothing where the history ends before the task.
  [[nodiscard]] std::optional<StepRange> done_from(std::size_t step) const;

 private:
  TaskHistory(StepRanges ranges, std::size_t work) : ranges_(std::move(ranges)), work_(work) {}
  [[nodiscard]] std::optional<StepRange> whole_from(std::size_t step) const;
  [[nodiscard]] std::optional<StepRange> split_from(std::size_t step) const;
  [[nodiscard]] std::size_t work_in(std::size_t begin, std::size_t end) const noexcept;

  StepRanges ranges_;
  std::size_t work_ = 1;
  std::optional<Visits> visits_;
  std::vector<std::size_t> worked_before_;  ///< steps of work in all runs before each, and in all
};

}  // namespace slackwater::twin
