#pragma once
#include <functional>

#include "api/ask/windows/windows.h"

namespace slackwater::api {

/// How much is flown.
struct FlyWindows {
  double most_wall_s = 1200;   ///< of the clock, for all tasks together
  double narrow_enough = 0.3;  ///< width of the interval at which a start needs no more flights
  Duration every = std::chrono::hours(1);  ///< from one start that is flown to the next, at least
  /// Whether the best start of a task that is no go, if not all its flights were done, is flown
  /// otherwise too (`advice_for`), within a quarter of the task's time.
  bool with_advice = false;
};

/// Flies the starts of each task that the limits leave open in a member at least, in the members of
/// the forecast, fills `TaskStart::twin` and gives worth and verdicts anew (`weigh_by_flights`).
/// First every start once, however long that takes, then those of whose success least is known,
/// until the intervals are narrow enough or the time of the task is over; what is in the air is
/// flown to its end. Of the time that is left a task has a share by its starts.
/// @param on_progress  share of the tasks
/// @throws as `windows_of`
void fly_windows(const WindowsQuestion& question, const FlyWindows& settings,
                 const std::filesystem::path& store_folder, WindowsAnswer& answer,
                 const std::function<void(double share)>& on_progress = {});

}  // namespace slackwater::api
