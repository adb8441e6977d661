#include "api/ask/windows/worth.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "twin/chance/success_interval.h"

namespace slackwater::api {
namespace {

bool is_flown(const TaskStart& start) { return start.twin && start.twin->flights > 0; }

double as_flown(const TaskStart& start) {
  const auto flights = static_cast<double>(start.twin->flights);
  return worth_as_flown(start.probability,
                        static_cast<std::size_t>(std::lround(start.twin->probability * flights)),
                        start.twin->flights);
}

}  // namespace

double worth_as_flown(double probability, std::size_t done, std::size_t flights) {
  if (twin::success_interval(done, flights).high >= probability) return probability;
  return std::min(probability, twin::next_success(done, flights));
}

void weigh_by_flights(TaskWindows& task, Duration near) {
  for (TaskStart& start : task.starts) {
    start.worth = std::min(start.probability, start.most_worth);
    start.flights_stopped_by.clear();
    // Those that were flown about it; a start that was flown itself has no others.
    const TaskStart* before = is_flown(start) ? &start : nullptr;
    const TaskStart* after = nullptr;
    for (const TaskStart& other : task.starts) {
      if (is_flown(start) || !is_flown(other)) continue;
      if (other.start < start.start) before = &other;
      if (other.start > start.start && after == nullptr) after = &other;
    }
    for (const TaskStart* flown : {before, after}) {
      if (flown == nullptr || std::chrono::abs(flown->start - start.start) > near) continue;
      const double worth = as_flown(*flown);
      if (worth >= flown->probability || worth >= start.worth) continue;
      start.worth = worth;
      start.flights_stopped_by = flown->twin->stopped_by;
    }
  }
}

std::vector<WorthRun> runs_of_worth(const TaskWindows& task, double from, double below) {
  std::vector<WorthRun> runs;
  bool was_in = false;
  for (std::size_t i = 0; i < task.starts.size(); ++i) {
    const TaskStart& start = task.starts[i];
    const bool is_in = start.forbidden.empty() && start.worth >= from && start.worth < below;
    if (is_in && !was_in) runs.push_back({i, i, start.worth, start.worth});
    if (is_in) {
      runs.back().last = i;
      runs.back().least = std::min(runs.back().least, start.worth);
      runs.back().most = std::max(runs.back().most, start.worth);
    }
    was_in = is_in;
  }
  return runs;
}

std::optional<double> flights_leave(const TaskWindows& task, UtcTime time) {
  std::optional<double> least;
  for (std::size_t i = 0; i < task.starts.size(); ++i) {
    const bool is_before = task.starts[i].start <= time &&
                           (i + 1 == task.starts.size() || task.starts[i + 1].start > time);
    const bool is_after =
        task.starts[i].start >= time && (i == 0 || task.starts[i - 1].start < time);
    if ((is_before || is_after) && task.starts[i].worth < task.starts[i].probability)
      least = std::min(least.value_or(1), task.starts[i].worth);
  }
  return least;
}

const TaskStart* best_of(const TaskWindows& task) {
  const TaskStart* best = nullptr;
  const TaskStart* by_day = nullptr;
  for (const TaskStart& start : task.starts) {
    if (best == nullptr || start.worth > best->worth) best = &start;
    if (start.is_by_day && start.forbidden.empty() &&
        (by_day == nullptr || start.worth > by_day->worth))
      by_day = &start;
  }
  const auto verdict = [&](const TaskStart& start) {
    return twin::verdict_of(start.worth, task.rule);
  };
  constexpr double least_gain = 0.1;
  const bool will_do = by_day != nullptr && verdict(*best) != twin::Verdict::no_go &&
                       verdict(*by_day) == verdict(*best) &&
                       by_day->worth >= best->worth - least_gain;
  return will_do ? by_day : best;
}

const TaskStart* best_flown(const TaskWindows& task) {
  const auto key = [](const TaskStart& start) {
    return std::tuple(start.worth, start.twin->interval.low);
  };
  const TaskStart* best = nullptr;
  for (const TaskStart& start : task.starts)
    if (start.twin && (best == nullptr || key(start) > key(*best))) best = &start;
  return best;
}

}  // namespace slackwater::api
