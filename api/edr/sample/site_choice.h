#pragma once
#include <string>

#include "api/edr/sample/queries.h"

// Which site's forecast answers a query that names no instance.

namespace slackwater::api::edr {

/// The site whose forecast reaches the place that the query points at: the first vertex of points
/// and lines, the middle of areas and boxes; else any site with a column within the shape. Null
/// where no forecast reaches it.
/// @throws Error(usage) where `coords` or `bbox` is missing or cannot be read
[[nodiscard]] const ForecastCatalogue::SiteForecast* site_for(const ForecastCatalogue& catalogue,
                                                              const QueryType& type,
                                                              const QueryString& query);

/// "the forecasts in force reach SITE (longitude ..., latitude ..., ...)": what a refusal tells.
[[nodiscard]] std::string reach_of(const ForecastCatalogue& catalogue);

}  // namespace slackwater::api::edr
