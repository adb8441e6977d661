#pragma once
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "api/door/edr/sample/collection.h"
#include "api/door/edr/sample/product_collection.h"
#include "api/issued/site_state.h"

// What the service says of itself: landing page, conformance, collections, instances (OGC API-EDR
// 1.1, clauses 7 and 8). `base` is the address of the service without a slash at its end.

namespace slackwater::api::edr {

/// With the sites, how old and how whole the forecast of each is.
[[nodiscard]] nlohmann::json landing_page(const std::string& base,
                                          const ForecastCatalogue& catalogue,
                                          const Freshness& freshness);
/// The classes whose requirements tests/api/edr covers, and no others.
[[nodiscard]] nlohmann::json conformance();

[[nodiscard]] nlohmann::json collections_document(const std::string& base,
                                                  const ForecastCatalogue& catalogue);
/// A collection over the forecasts in force.
[[nodiscard]] nlohmann::json collection_document(const std::string& base,
                                                 const Collection& collection,
                                                 const ForecastCatalogue& catalogue);
[[nodiscard]] nlohmann::json instances_document(const std::string& base,
                                                const Collection& collection,
                                                const ForecastCatalogue& catalogue);
/// One issued forecast of a collection; identifier, title, description and extent as in the list.
[[nodiscard]] nlohmann::json instance_document(const std::string& base,
                                               const Collection& collection,
                                               const ForecastCatalogue& catalogue,
                                               const IssuedForecast& forecast);

/// A collection over a stored product: it has no instances and no items.
[[nodiscard]] nlohmann::json product_document(const std::string& base, const StoredProduct& product,
                                              const ForecastCatalogue& catalogue);

/// The extent of fields as OGC wants it: box, times, verticals.
[[nodiscard]] nlohmann::json extent_of(const Collection& collection,
                                       const std::vector<std::shared_ptr<const Field>>& fields);

}  // namespace slackwater::api::edr
