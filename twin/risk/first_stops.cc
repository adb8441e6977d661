#include "twin/risk/first_stops.h"

#include <algorithm>
#include <cmath>

namespace slackwater::twin {
namespace {

FirstStops no_stops(std::size_t starts) {
  return {std::vector<std::uint32_t>(starts, never_stopped),
          std::vector<std::uint16_t>(starts, no_limit)};
}

/// For each step the next one, itself among them, at which a value is not within the bound.
void note_next_stop(const WatchedLimit& watched, std::span<const double> values,
                    std::vector<std::uint32_t>& next) {
  const auto note = [&](auto stops) {
    std::uint32_t found = never_stopped;
    for (std::size_t i = values.size(); i-- > 0;) {
      if (stops(values[i])) found = static_cast<std::uint32_t>(i);
      next[i] = found;
    }
  };
  const Bound bound = watched.bound;
  if (watched.may_be_missing)
    note([&](double value) { return !bound.holds(value) && !std::isnan(value); });
  else
    note([&](double value) { return !bound.holds(value); });
}

/// Of two that stop at the same step the one that was listed first stays.
void add_stops(const StartQuestion& question, const WatchedLimit& watched,
               const std::vector<std::uint32_t>& next, FirstStops& first) {
  for (std::size_t s = 0; s < question.starts.count; ++s) {
    const std::size_t from = question.starts.step_of(s) - watched.before;
    for (const StepRange& when : watched.when) {
      const std::uint32_t stop = next[from + when.begin];
      if (stop >= from + when.end) continue;
      if (stop < first.step[s]) {
        first.step[s] = stop;
        first.limit[s] = static_cast<std::uint16_t>(watched.limit);
      }
      break;
    }
  }
}

void merge(const FirstStops& other, FirstStops& first) {
  for (std::size_t s = 0; s < first.step.size(); ++s) {
    if (other.step[s] >= first.step[s]) continue;
    first.step[s] = other.step[s];
    first.limit[s] = other.limit[s];
  }
}

/// For each step whether all limits hold, and the next limit that does not.
struct SplitSteps {
  StepMarks usable;
  FirstStops next;  ///< of each step, itself among them
};

SplitSteps split_steps(const StartQuestion& question, std::size_t member, bool with_alpha) {
  SplitSteps steps{StepMarks(question.steps, 1), no_stops(question.steps)};
  for (const WatchedLimit& watched : question.watched) {
    const auto values = watched.members[watched.members.size() > 1 ? member : 0];
    Bound bound = watched.bound;
    if (with_alpha && !watched.alpha.empty() && !std::isnan(watched.alpha.front()))
      bound.value *= watched.alpha.front();
    for (std::size_t i = 0; i < question.steps; ++i) {
      if (bound.holds(values[i]) || (watched.may_be_missing && std::isnan(values[i]))) continue;
      if (steps.usable[i] == 1) steps.next.limit[i] = static_cast<std::uint16_t>(watched.limit);
      steps.usable[i] = 0;
    }
  }
  std::uint32_t found = never_stopped;
  std::uint16_t limit = no_limit;
  for (std::size_t i = question.steps; i-- > 0;) {
    if (steps.usable[i] == 0) {
      found = static_cast<std::uint32_t>(i);
      limit = steps.next.limit[i];
    }
    steps.next.step[i] = found;
    steps.next.limit[i] = limit;
  }
  return steps;
}

/// A start is kept where a visit can begin then and the visits from it on come to all of the work.
FirstStops split_stops(const StartQuestion& question, std::size_t member, bool with_alpha) {
  const SplitWork& split = *question.split;
  const SplitSteps steps = split_steps(question, member, with_alpha);
  const std::span<const std::uint8_t> in_time(steps.usable.data(), split.by_step);
  const TaskHistory history = TaskHistory::split(runs_of(in_time), split.work, split.visits);
  FirstStops first = no_stops(question.starts.count);
  for (std::size_t s = 0; s < question.starts.count; ++s) {
    const std::size_t from = question.starts.step_of(s);
    const auto done = history.done_from(from);
    if (done && done->begin == from) continue;
    if (steps.next.step[from] < split.by_step) {
      first.step[s] = steps.next.step[from];
      first.limit[s] = steps.next.limit[from];
    } else {
      first.step[s] = static_cast<std::uint32_t>(split.by_step);
      first.limit[s] = static_cast<std::uint16_t>(split.limit);
    }
  }
  return first;
}

}  // namespace

std::vector<FirstStops> first_stops(const StartQuestion& question) {
  if (question.split) {
    std::vector<FirstStops> all;
    for (std::size_t m = 0; m < question.members; ++m)
      all.push_back(split_stops(question, m, false));
    return all;
  }
  std::vector<std::uint32_t> next(question.steps);
  FirstStops shared = no_stops(question.starts.count);
  for (const WatchedLimit& watched : question.watched) {
    if (watched.members.size() > 1) continue;
    note_next_stop(watched, watched.members.front(), next);
    add_stops(question, watched, next, shared);
  }
  std::vector<FirstStops> all(question.members, no_stops(question.starts.count));
  for (std::size_t m = 0; m < question.members; ++m) {
    for (const WatchedLimit& watched : question.watched) {
      if (watched.members.size() <= 1) continue;
      note_next_stop(watched, watched.members[m], next);
      add_stops(question, watched, next, all[m]);
    }
    merge(shared, all[m]);
  }
  return all;
}

FirstStops central_stops_with_alpha(const StartQuestion& question) {
  return split_stops(question, 0, true);
}

}  // namespace slackwater::twin
