#pragma once
#include <span>
#include <vector>

#include "calibration/provider/provider_runs.h"
#include "calibration/skill/baseline.h"
#include "calibration/tide/fitted_tide.h"

namespace slackwater::calibration {

/// Runs that ended earlier before the end of D say nothing of the error.
inline constexpr Duration runs_looked_back = std::chrono::hours(72);

/// A provider's forecast at asked cells and levels: as it is, and with the error that its runs
/// have made of late carried on.
struct ProviderForecast {
  BaselineForecast as_it_is;
  BaselineForecast corrected;
  std::vector<double> corrected_sigma_m_s;  ///< of a component, where there is a value
};

/// What a provider's runs say, held against the record.
///
/// Error on the last three days, level by level: the record less the run over the run's own cells;
/// where the runs lack the tide that the record has, it is taken from the record first, and added
/// to the forecast (series_at.h). Four runs at most, twelve values of each (run_error.h). A run is
/// never held against itself: where the record is of a run, that run has no error there.
///
/// @param runs        at the column, as known
/// @param known       the record up to the end of D, on the levels asked for
/// @param tide        of that record
/// @param cells       asked for, after the end of D
/// @param end_of_day  24:00 of D
[[nodiscard]] ProviderForecast provider_forecast(const ProviderRuns& runs,
                                                 const Chosen<Horizontal>& known,
                                                 const FittedTide& tide, Angle latitude,
                                                 std::span<const TimeCell> cells,
                                                 UtcTime end_of_day);

/// The first half of it: nothing is held against a record.
[[nodiscard]] BaselineForecast provider_as_it_is(const ProviderRuns& runs,
                                                 const Chosen<Horizontal>& known,
                                                 const FittedTide& tide,
                                                 std::span<const TimeCell> cells);

}  // namespace slackwater::calibration
