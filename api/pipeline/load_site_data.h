#pragma once
#include <optional>

#include "data/store/store.h"
#include "fields/record/site_data.h"

namespace slackwater::api {

/// Reads what the store holds for the site from `from` to `to` and looks at it from each column
/// (fields/record/site_data.h). A site with no data of any kind is Error(not_found).
[[nodiscard]] SiteData load_site_data(store::Store& store, const Site& site, UtcTime from,
                                      UtcTime to);

/// The water depth at a site's own point by the bathymetry in the store, m; nothing where none is
/// stored there.
[[nodiscard]] std::optional<double> bathymetry_at(store::Store& store, const Site& site);

}  // namespace slackwater::api
