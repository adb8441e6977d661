#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "api/door/edr/read/query_string.h"
#include "api/door/edr/sample/collection.h"
#include "api/door/edr/sample/product_collection.h"
#include "api/issued/issued_fields.h"

// Locations (the columns of each site) and items (issued forecasts) as GeoJSON features.

namespace slackwater::api::edr {

/// Locations of the forecasts in force, or of one forecast; which of them the query
/// says (feature_filter.h).
[[nodiscard]] nlohmann::json locations_document(
    const std::string& at, const Collection& collection,
    const std::vector<std::shared_ptr<const Field>>& fields, const QueryString& query);

/// The columns of each site that a stored product covers.
[[nodiscard]] nlohmann::json product_locations_document(const std::string& at,
                                                        const StoredProduct& product,
                                                        const ForecastCatalogue& catalogue,
                                                        const QueryString& query);

[[nodiscard]] nlohmann::json items_document(const std::string& base, const Collection& collection,
                                            const ForecastCatalogue& catalogue,
                                            const QueryString& query);
[[nodiscard]] nlohmann::json item_document(const std::string& base, const Collection& collection,
                                           const ForecastCatalogue& catalogue,
                                           const IssuedForecast& forecast);

}  // namespace slackwater::api::edr
