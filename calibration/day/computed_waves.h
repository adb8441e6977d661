#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "calibration/day/forecast_column.h"
#include "fields/wave/growth.h"

namespace slackwater::calibration {

/// What the waves of a forecast rest on where no wave product speaks.
struct ComputedWaves {
  std::size_t hours = 0;  ///< of the forecast's stamps, without a wave product
  std::size_t of_hours = 0;
  bool of_wind_alone = false;  ///< nor is any sea known before them: no swell from elsewhere
  bool is_kept = false;        ///< without wind: the last known sea, kept
  Fetch fetch = assumed_fetch();
  bool is_fetch_assumed = true;  ///< the site's file gives none
  double highest_m = 0;          ///< significant height over these hours
  /// The same had the fetch been half as long, and twice; where it is assumed.
  std::optional<double> highest_half_fetch_m;
  std::optional<double> highest_twice_fetch_m;
};

/// Of a column as it was forecast; nothing where products give all its waves, or it has none.
[[nodiscard]] std::optional<ComputedWaves> computed_waves(const ColumnForecast& made,
                                                          const ColumnData& column,
                                                          const Site& site,
                                                          const ForecastPlan& plan,
                                                          const ColumnParts& parts = {});

/// Whether a forecast with these waves is degraded: more than six hours of them (a six-hourly
/// product ends that much before a day does) unless `persist` asked for it, and any that are of the
/// wind alone.
[[nodiscard]] bool is_degradation(const ComputedWaves& waves, WindPolicy policy) noexcept;

/// One clause for a headline: how these waves were had, over which fetch, and what another fetch
/// would make of them.
[[nodiscard]] std::string text_of(const ComputedWaves& waves);

}  // namespace slackwater::calibration
