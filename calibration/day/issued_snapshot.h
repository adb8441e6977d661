#pragma once
#include <cstdint>
#include <vector>

#include "calibration/day/daily_forecast.h"

namespace slackwater::calibration {

/// The columns and what they share, as one forecast; without its headline.
[[nodiscard]] Snapshot snapshot_of(const SiteData& data, const ForecastPlan& plan,
                                   const std::vector<ColumnForecast>& columns);

/// Whose files the columns were made from, by which program, with which calibration.
[[nodiscard]] Provenance provenance_of(const SiteData& data, const ForecastOptions& options,
                                       const std::vector<ColumnForecast>& columns);

/// The granules whose values were used, ascending.
[[nodiscard]] std::vector<std::int64_t> granules_of(const std::vector<ColumnForecast>& columns);

}  // namespace slackwater::calibration
