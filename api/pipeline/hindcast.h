#pragma once
#include <functional>
#include <vector>

#include "api/pipeline/daily_job.h"
#include "calibration/verify/score_forecast.h"

namespace slackwater::api {

struct HindcastOptions {
  UtcDay from{};  ///< first day D
  UtcDay to{};    ///< last day D
  WindPolicy wind = WindPolicy::best;
  Duration latency{0};  ///< a day's data are available when it ends plus this
  Duration horizon = std::chrono::hours(72);
  /// Under `forecast`, where no run published by a day's issue time is stored: simulate one
  /// (calibration/day/given/simulated_run.h), and say so. Else the wind is held, as it was live.
  bool simulate_wind = false;
  std::uint64_t seed = 1;  ///< of members, and of simulated winds
  int threads = 2;
  calibration::VerifyOptions verify;
  calibration::DayParts parts;  ///< what does the work of a day
};

struct HindcastReport {
  std::vector<calibration::SkillEntry> skill;
  std::vector<std::int64_t> forecasts;  ///< ids in the store
  /// Of them, those whose wind was simulated: no run published by their issue time is stored.
  std::size_t simulated_winds = 0;
  std::vector<std::string> skipped;   ///< "2024-01-03: no whole day of currents"
  std::vector<std::string> unscored;  ///< issued, but their scoring failed: "2024-01-03: why"
};

/// The daily job over a past period as if live: each day D is forecast with what was known when it
/// ended plus the latency, stored as issued (origin hindcast), and scored against what the store
/// holds now. Best wind is that of hindsight, and the forecasts made with it say so. Days
/// without a whole day of currents, and days whose forecast fails, are skipped and named and do not
/// stop the others; a period without any forecast is an Error.
[[nodiscard]] HindcastReport hindcast(store::Store& store, const Site& site,
                                      const HindcastOptions& options,
                                      const std::function<void(double)>& progress);

}  // namespace slackwater::api
