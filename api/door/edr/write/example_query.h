#pragma once
#include <optional>
#include <string>

#include "api/door/edr/sample/collection.h"
#include "api/door/edr/sample/queries.h"
#include "api/issued/issued_fields.h"

// Queries that can be tried as they stand, for the documents of the service.

namespace slackwater::api::edr {

/// Where and when the examples ask: a column of a forecast.
struct Example {
  std::string site = "site";
  std::string instance = "site_20250310T050000Z";
  double longitude_deg = -2.55;
  double latitude_deg = 48.85;
  UtcTime time = parse_utc("2025-03-10T06:00:00Z");
  double depth_m = 10;  ///< half the water's, at most 10 m
};

/// Of the first site of a catalogue; made up where it has none.
[[nodiscard]] Example example_of(const ForecastCatalogue& catalogue);

/// Of one forecast, at a time at which its first column has what the collection offers; nothing
/// where it has none of that (a forecast without waves).
[[nodiscard]] std::optional<Example> example_of(const Collection& collection, const Field& field);

/// The `coords` of a query about the example's place: a point, a triangle or a line.
[[nodiscard]] std::string example_coords(std::string_view query, const Example& example);

/// What an example has for one of the parameters that a query cannot do without, but for z.
[[nodiscard]] std::string example_value(std::string_view name, std::string_view query,
                                        const Example& example);

/// The query string of an example, without '?': what the query cannot do without, one level and one
/// time.
[[nodiscard]] std::string example_query(const QueryType& type, const Collection& collection,
                                        const Example& example);

}  // namespace slackwater::api::edr
