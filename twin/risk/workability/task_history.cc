#include "twin/risk/workability/task_history.h"

#include <algorithm>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// The first range that ends after a step.
std::size_t first_after(const StepRanges& ranges, std::size_t step) {
  const auto found =
      std::upper_bound(ranges.begin(), ranges.end(), step,
                       [](std::size_t at, const StepRange& range) { return at < range.end; });
  return static_cast<std::size_t>(found - ranges.begin());
}

}  // namespace

TaskHistory TaskHistory::whole(StepRanges starts, std::size_t work) {
  expects(work > 0, "a task takes one step at least");
  return {std::move(starts), work};
}

TaskHistory TaskHistory::split(StepRanges usable, std::size_t work, Visits visits) {
  expects(work > 0, "a task takes one step at least");
  expects(visits.lost < visits.shortest, "some work is done in every visit");
  TaskHistory history(std::move(usable), work);
  history.visits_ = visits;
  history.worked_before_.push_back(0);
  for (const StepRange& run : history.ranges_)
    history.worked_before_.push_back(history.worked_before_.back() +
                                     history.work_in(run.begin, run.end));
  return history;
}

std::size_t TaskHistory::work_in(std::size_t begin, std::size_t end) const noexcept {
  return end - begin < visits_->shortest ? 0 : end - begin - visits_->lost;
}

std::optional<StepRange> TaskHistory::done_from(std::size_t step) const {
  return visits_ ? split_from(step) : whole_from(step);
}

std::optional<StepRange> TaskHistory::whole_from(std::size_t step) const {
  const std::size_t j = first_after(ranges_, step);
  if (j == ranges_.size()) return std::nullopt;
  const std::size_t begin = std::max(step, ranges_[j].begin);
  return StepRange{begin, begin + work_};
}

std::optional<StepRange> TaskHistory::split_from(std::size_t step) const {
  const std::size_t j = first_after(ranges_, step);
  if (j == ranges_.size()) return std::nullopt;
  // The rest of the run that one is in, then whole runs: their sums stand ready.
  const std::size_t here = std::max(step, ranges_[j].begin);
  const std::size_t now = work_in(here, ranges_[j].end);
  if (now >= work_) return StepRange{here, here + visits_->lost + work_};
  const std::size_t wanted = worked_before_[j + 1] + (work_ - now);
  const auto found = std::lower_bound(worked_before_.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                                      worked_before_.end(), wanted);
  if (found == worked_before_.end()) return std::nullopt;
  const auto last = static_cast<std::size_t>(found - worked_before_.begin()) - 1;
  const std::size_t rest = wanted - worked_before_[last];
  std::size_t begin = here;
  if (now == 0) {  // the first run that is long enough for a visit
    const auto first = std::upper_bound(worked_before_.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                                        worked_before_.end(), worked_before_[j + 1]);
    begin = ranges_[static_cast<std::size_t>(first - worked_before_.begin()) - 1].begin;
  }
  return StepRange{begin, ranges_[last].begin + visits_->lost + rest};
}

}  // namespace slackwater::twin
