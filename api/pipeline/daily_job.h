#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "api/pipeline/forecast_column.h"
#include "api/pipeline/rehearsal.h"
#include "api/pipeline/site_data.h"
#include "data/store/store.h"
#include "fields/service/snapshot.h"

namespace slackwater::api {

struct JobOptions {
  std::optional<UtcDay> day;  ///< D; absent: the newest day the store holds throughout
  UtcTime issued{};           ///< when the job runs
  Duration horizon = std::chrono::hours(72);  ///< beyond the end of D
  WindPolicy wind = WindPolicy::best;
  std::string origin = "forecast";  ///< forecast | hindcast
  int threads = 1;
  std::uint64_t seed = 1;  ///< of the members
  /// Rehearsed days to share between the jobs of a hindcast over the same data; null: the job's own.
  Rehearsals* rehearsals = nullptr;
};

/// A forecast made, not yet stored.
struct DailyForecast {
  Snapshot snapshot;
  std::vector<ColumnForecast>
      columns;  ///< calibrations, notes and origins, in the snapshot's order
  std::vector<std::int64_t> input_granules;
  std::string dataset;           ///< of the currents; empty where there are none
  std::optional<Earned> earned;  ///< weights and spread; nothing where no current is forecast
  std::string summary_json;      ///< calibration report, inputs, effective configuration
};

/// How much history a job reads for the tide: two spring-neap cycles and a month beyond.
inline constexpr Duration history_read = std::chrono::days(60);

/// The newest day up to the issue time for which the currents of the site are held throughout;
/// nothing where there is none.
[[nodiscard]] std::optional<UtcDay> newest_whole_day(const SiteData& data, UtcTime issued);

/// Whether a day's currents are there: no gap at its ends or within it wider than two and a half
/// usual steps (of two and a half hours for series finer than hourly).
[[nodiscard]] bool holds_throughout(const VectorColumn& currents, UtcDay day);

/// Whether the currents of this day are held throughout, as known at the issue time.
[[nodiscard]] bool holds_day(const SiteData& data, UtcDay day, UtcTime issued);

/// The daily job without the store: calibrate on D, propagate to the horizon, wind and waves beside
/// it. Where D lacks currents it falls back on the last good day before it (longer lead, wider
/// bands, `degraded`, a headline that says so); without any currents the forecast carries wind and
/// waves alone.
[[nodiscard]] DailyForecast make_forecast(const SiteData& data, const JobOptions& options);

/// Writes the forecast's file and stores it as issued; returns its id.
std::int64_t publish(store::Store& store, const DailyForecast& forecast, const JobOptions& options);
/// Several at once, all or none (hindcast).
std::vector<std::int64_t> publish(store::Store& store, std::span<const DailyForecast> forecasts,
                                  const JobOptions& options);

}  // namespace slackwater::api
