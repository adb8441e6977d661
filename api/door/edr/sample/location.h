#pragma once
#include <cstddef>
#include <optional>
#include <string>

#include "api/issued/issued_fields.h"

namespace slackwater::api::edr {

/// A column of a forecast by name: "SITE" the first, "SITE.k" the k-th, counted from 0.
struct LocationName {
  std::string site_id;
  std::size_t column = 0;
};

/// Nothing where no such location is in the catalogue (or among the columns
/// of `field`, where given).
[[nodiscard]] std::optional<LocationName> location_named(const std::string& name,
                                                         const ForecastCatalogue& catalogue,
                                                         const Field* field = nullptr);

}  // namespace slackwater::api::edr
