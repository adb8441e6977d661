#pragma once
#include <span>
#include <string>

#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/horizon.h"
#include "calibration/propagate/ensemble_wind.h"

namespace slackwater::calibration {

/// How the ensemble's members depart from the wind of the horizon, at the stamps:
///
///   e_n = x_mean + f (x_n - x_mean) - wind
///
/// f: the factor on the spread that past runs ask for at that lead (`SpreadCheck::factor_at`).
/// Nothing where the wind was analysed or measured: a run from before is not what it is in doubt
/// by. Empty where nothing is left.
/// @param stamps  of the horizon
[[nodiscard]] WindDepartures departures_of(const HorizonWind& wind,
                                           std::span<const UtcTime> stamps);

/// "NWP_ecmf issued 2024-06-12T00:00:00Z".
[[nodiscard]] std::string text_of(const WindEnsembleRun& run);

/// One sentence on whose wind the members have, how its spread stands to its error, and at how many
/// stamps after D it had to be raised or stood in for.
/// @param members  of the forecast, beside the central one
[[nodiscard]] std::string note_on(const WindEnsembleRun& run, const WindDepartures& ensemble,
                                  std::size_t members, const ForecastPlan& plan);

/// Whether the run was issued after what `best` may look at.
[[nodiscard]] bool looks_ahead(const WindEnsembleRun& run, const ForecastPlan& plan);

}  // namespace slackwater::calibration
