#pragma once
#include <cstddef>
#include <vector>

#include "fields/current/tide.h"
#include "fields/interpolate/column.h"

namespace slackwater::calibration {

/// Shorter records show no tide (fields/current/tide.h).
inline constexpr Duration shortest_tide_record = std::chrono::days(3);
/// The least error of a level, m: what that of a model's cell says of one place (estimate).
inline constexpr double least_level_sigma_m = 0.03;

/// How what departs from the harmonic tide, the surge, is carried on from the end of a record:
///
///   level(t) = mean + tide(t) + s e^{-(t - t0) / memory}
///
/// with s the mean departure of the record's last `window`.
struct SurgeMemory {
  Duration memory{0};  ///< 0: nothing is carried on
  Duration window{0};  ///< 0: the last value alone
};

/// What a forecast of a level is expected to err by: standard deviation, m, of leads in [0, 12) h,
/// [12, 24) h, ... ; the last of them for all that is later.
struct LevelErrors {
  std::vector<double> sigma_m;
  [[nodiscard]] double at(Duration lead) const noexcept;
};

/// What past days of a record would have been, had they been forecast.
struct LevelHindcast {
  SurgeMemory surge;   ///< of those that are tried the one of least error
  LevelErrors errors;  ///< of it
  std::size_t days = 0;
};

/// Forecasts the days of a record from what stood before each: every 24 h back from its end, as far
/// as the record before is at least half of the whole and three days, at most 21 of them. Each has
/// a tide of its own, fitted to the values before it alone. Errors never fall with lead, and are
/// at least `least_level_sigma_m`.
///
/// With fewer than three such days: a memory of one day, the mean of the last 25 h, and the prior
///
///   sigma^2 = (0.10 m)^2 + (0.1 x rms of the tide)^2 + (rms of the residual)^2   (estimate),
///
/// with days = 0.
/// @param known    one level, ascending, three days and more
/// @param horizon  leads beyond are not looked at
[[nodiscard]] LevelHindcast hindcast_level(const ScalarColumn& known, Duration horizon);

/// s of `SurgeMemory`: the departure of the last window of the values from the fit; 0 for none.
[[nodiscard]] double departure_at_end(const ScalarColumn& known, const TideFit& fit,
                                      Duration window);

/// What is left of a departure after a time; all of it before.
[[nodiscard]] double share_left(const SurgeMemory& surge, Duration after) noexcept;

}  // namespace slackwater::calibration
