#pragma once
#include <cstddef>
#include <vector>

#include "api/ask/windows/windows.h"

namespace slackwater::api {

/// What flights leave of the chance that all limits of a start hold: where the 95 % interval of
/// their success shuts it out from above, no more than they say, `next_success` of them; else all
/// of it. They never add to it.
[[nodiscard]] double worth_as_flown(double probability, std::size_t done, std::size_t flights);

/// Sets `TaskStart::worth` of all starts from their flights. One that was not flown is worth no
/// more than the worse of its neighbours of which flights took something.
/// @param near  how far away a neighbour may be
void weigh_by_flights(TaskWindows& task, Duration near);

/// Starts one after the other whose worth is in a range.
struct WorthRun {
  std::size_t first = 0;  ///< of the starts
  std::size_t last = 0;
  double least = 1;
  double most = 0;
};
/// The maximal runs of starts that are worth `from` and more, and less than `below`.
[[nodiscard]] std::vector<WorthRun> runs_of_worth(const TaskWindows& task, double from,
                                                  double below);

/// What there is to say of a time between starts: the least worth of its neighbours that flights
/// took something from; nothing where they took nothing.
[[nodiscard]] std::optional<double> flights_leave(const TaskWindows& task, UtcTime time);

/// The start that is worth most, the first of them; by day where one then has the same verdict and
/// is worth at most 0.1 less: nobody sails at midnight for two per cent. Nothing where there is no
/// start.
[[nodiscard]] const TaskStart* best_of(const TaskWindows& task);
/// Of the starts that were flown the one that is worth most; null where none was.
[[nodiscard]] const TaskStart* best_flown(const TaskWindows& task);

}  // namespace slackwater::api
