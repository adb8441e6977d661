#pragma once
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "api/edr/read/query_string.h"
#include "api/edr/sample/collection.h"
#include "api/issued/issued_fields.h"

// Locations (the columns of each site) and items (issued forecasts) as GeoJSON features.

namespace slackwater::api::edr {

/// A column of a forecast by name: "SITE" the first, "SITE.k" the k-th, counted from 0.
struct LocationName {
  std::string site_id;
  std::size_t column = 0;
};
/// Nothing where no such location is in the catalogue (or among the columns of `field`, where given).
[[nodiscard]] std::optional<LocationName> location_named(const std::string& name,
                                                         const ForecastCatalogue& catalogue,
                                                         const Field* field = nullptr);

/// Locations of the forecasts in force, or of one forecast; which of them the query says (feature_filter.h).
[[nodiscard]] nlohmann::json locations_document(
    const std::string& at, const Collection& collection,
    const std::vector<std::shared_ptr<const Field>>& fields, const QueryString& query);

[[nodiscard]] nlohmann::json items_document(const std::string& base, const Collection& collection,
                                            const ForecastCatalogue& catalogue,
                                            const QueryString& query);
[[nodiscard]] nlohmann::json item_document(const std::string& base, const Collection& collection,
                                           const ForecastCatalogue& catalogue,
                                           const IssuedForecast& forecast);

}  // namespace slackwater::api::edr
