#include "api/ask/windows/relief.h"

#include <algorithm>
#include <set>

#include "twin/chance/success_interval.h"
#include "twin/risk/held_without.h"

namespace slackwater::api {
namespace {

/// The limits that are the first to stop most members of a start, of any.
std::set<std::size_t> stopping_limits(const TaskWindows& task) {
  std::set<std::size_t> limits;
  for (const TaskStart& start : task.starts)
    if (start.chance.binding && start.chance.binding->is_exceeded)
      limits.insert(start.chance.binding->limit);
  return limits;
}

}  // namespace

std::vector<Relief> reliefs_of(const Outlook& outlook, const TaskWindows& task) {
  double best = 0;
  for (const TaskStart& start : task.starts) best = std::max(best, start.probability);
  std::vector<Relief> reliefs;
  for (const std::size_t limit : stopping_limits(task)) {
    const std::vector<std::size_t> held = twin::held_without(outlook.question, limit);
    Relief relief{limit, {}, 0};
    for (std::size_t s = 0; s < task.starts.size(); ++s) {
      if (!task.starts[s].forbidden.empty()) continue;
      const double probability = task.calibration(twin::next_success(held[s], task.futures));
      if (probability > relief.probability) relief = {limit, task.starts[s].start, probability};
    }
    if (relief.probability >= best + least_relief) reliefs.push_back(relief);
  }
  std::stable_sort(reliefs.begin(), reliefs.end(),
                   [](const Relief& a, const Relief& b) { return a.probability > b.probability; });
  return reliefs;
}

}  // namespace slackwater::api
