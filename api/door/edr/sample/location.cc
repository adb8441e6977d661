#include "api/door/edr/sample/location.h"

#include <charconv>

namespace slackwater::api::edr {

std::optional<LocationName> location_named(const std::string& name,
                                           const ForecastCatalogue& catalogue, const Field* field) {
  const auto columns_of = [&](const std::string& site) -> std::size_t {
    if (field != nullptr)
      return field->snapshot().site_id == site ? field->snapshot().columns.size() : 0;
    for (const auto& known : catalogue.sites)
      if (known.site_id == site) return known.field->snapshot().columns.size();
    return 0;
  };
  if (columns_of(name) > 0) return LocationName{name, 0};
  const std::size_t dot = name.rfind('.');
  if (dot == std::string::npos || dot + 1 == name.size()) return std::nullopt;
  LocationName found{name.substr(0, dot), 0};
  const char* end = name.data() + name.size();
  const auto [last, problem] = std::from_chars(name.data() + dot + 1, end, found.column);
  if (problem != std::errc{} || last != end || found.column >= columns_of(found.site_id))
    return std::nullopt;
  return found;
}

}  // namespace slackwater::api::edr
