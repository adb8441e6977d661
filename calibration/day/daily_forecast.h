#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "calibration/day/computed_waves.h"
#include "calibration/day/day_parts.h"
#include "calibration/day/forecast_column.h"
#include "calibration/day/given/forecast_plan.h"
#include "calibration/day/given/stand_in.h"
#include "calibration/day/rehearsal.h"
#include "fields/record/site_data.h"
#include "fields/service/snapshot.h"

namespace slackwater::calibration {

struct ForecastOptions {
  std::optional<UtcDay> day;  ///< D; absent: the newest day that the data hold throughout
  UtcTime issued{};           ///< when the job runs
  /// What came into the store later is not looked at, where the store was being filled by then
  /// (Knowledge::seen_by); a hindcast looks at all of an archive.
  UtcTime seen_by = UtcTime::max();
  Duration horizon = std::chrono::hours(72);  ///< beyond the end of D
  WindPolicy wind = WindPolicy::best;
  /// Under `best`: wind and waves that were not known at the issue time are used as well, and the
  /// forecast says so.
  bool hindsight = false;
  /// Of a past day of which no run of the wind was kept: `BestInputs::simulated_seed`, from `seed`.
  bool simulate_wind = false;
  int threads = 1;
  std::uint64_t seed = 1;    ///< of the members
  int members = 24;          ///< beside the central one; a member is the same whatever their number
  std::string code_version;  ///< of the program that makes the forecast, for its provenance
  /// Rehearsed days to share between forecasts of the same data; null: the forecast's own.
  RehearsedDays* rehearsals = nullptr;
  DayParts parts;  ///< what does the work
};

/// A forecast with all that it rests on.
struct DailyForecast {
  Snapshot snapshot;
  ForecastPlan plan;
  /// Calibrations, notes and origins, in the snapshot's order. Origins are owned by the data.
  std::vector<ColumnForecast> columns;
  std::vector<std::int64_t> input_granules;
  std::optional<Earned> earned;  ///< weights and spread; nothing where no current is forecast
  std::optional<ComputedWaves> computed_waves;  ///< of the first column with waves, where they are
  std::optional<StandIn> stand_in;              ///< of another product for the leading one
  std::vector<PartFailure> failures;            ///< of parts that are made once for all columns
};

/// How much of the record before D a forecast wants from its caller: for the tide, two spring-neap
/// cycles and a month beyond.
inline constexpr Duration history_wanted = std::chrono::days(60);

/// The forecast of a site from its data alone: calibrate on D, propagate to the horizon, wind and
/// waves beside it, blended as the rehearsed past has earned. Pure: no store, no clock; the same
/// for any number of threads.
///
/// Where D lacks currents it falls back on the last good day before it (longer lead, wider bands,
/// `degraded`, a headline that says so); without any currents the forecast carries wind and waves
/// alone. A part that fails (DayParts) is left out, `degraded` and named in the headline;
/// everything else is what it would be without that part. Error(not_found) where the last good day
/// is too long ago to forecast from; an Error too where not one value could be forecast.
[[nodiscard]] DailyForecast make_forecast(const SiteData& data, const ForecastOptions& options);

}  // namespace slackwater::calibration
