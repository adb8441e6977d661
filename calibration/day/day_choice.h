#pragma once
#include <optional>
#include <string>

#include "calibration/day/daily_forecast.h"

namespace slackwater::calibration {

/// Which day is forecast from, and which should have been.
struct DayChoice {
  UtcDay wanted{};
  std::optional<UtcDay> usable;  ///< nothing: no whole day of currents is known
  std::string dataset;           ///< of the usable day's currents
  Duration averaging{0};         ///< of them
  /// The leading dataset, where it has no whole day near enough and another stands in; else empty.
  std::string stands_in_for;
};

/// The day of the options where the data hold it, else the newest whole day before it. Where the
/// choice fails (`failures`) no day is usable.
[[nodiscard]] DayChoice choose_day(const SiteData& data, const ForecastOptions& options,
                                   std::vector<PartFailure>& failures);

/// The plan of a forecast from that day. Error(not_found) where it is too long ago.
[[nodiscard]] ForecastPlan plan_of(const SiteData& data, const ForecastOptions& options,
                                   const DayChoice& choice);

}  // namespace slackwater::calibration
