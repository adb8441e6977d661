#pragma once
#include <vector>

#include "api/door/http/health.h"
#include "api/door/http/metrics.h"
#include "api/issued/site_state.h"

// What `/health` and `/metrics` say of the forecasts.

namespace slackwater::api {

/// The first of these words that holds:
///
///   unavailable  the store cannot be read: new forecasts go unnoticed   (the only one of no use)
///   empty        the store holds no forecast
///   stale        a site's newest forecast is too old, or none of its forecasts can be read
///   degraded     a forecast file cannot be read, or one in force was made without all its inputs
///   ok
///
/// and per site the age of the forecast in force.
[[nodiscard]] http::HealthFacts health_of(const IssuedFields& forecasts,
                                          const Freshness& freshness);

/// Gauges by site: age in seconds, stale and degraded as 0 or 1.
[[nodiscard]] std::vector<http::Gauge> forecast_gauges(const ForecastCatalogue& catalogue,
                                                       const Freshness& freshness);

}  // namespace slackwater::api
