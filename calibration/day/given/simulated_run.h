#pragma once
#include <span>

#include "calibration/day/given/horizon.h"
#include "fields/record/choose.h"

namespace slackwater::calibration {

/// Whether the wind of most of the first day after D is known, not held.
[[nodiscard]] bool reaches_beyond(const HorizonWind& wind, std::span<const UtcTime> stamps,
                                  UtcTime end_of_day);

/// A run of a weather model as it may have been, where none was kept: the wind as analysed later,
/// with an error after D drawn from the law by which forecasts of the wind err (wind_error.h). The
/// run is the newest that `best.issued` could have had of a model that runs every six hours and
/// publishes 7 h 34 min later (ECMWF's dissemination schedule). The draw depends on
/// `best.simulated_seed` and the day alone.
[[nodiscard]] Chosen<Horizontal> with_simulated_run(Chosen<Horizontal> analysed, UtcTime end_of_day,
                                                    const BestInputs& best);

}  // namespace slackwater::calibration
