#pragma once
#include <optional>

#include "calibration/day/daily_forecast.h"
#include "data/store/store.h"
#include "fields/record/site_data.h"

namespace slackwater::api {

/// Reads what the store holds for the site from `from` to `to` and looks at it from each column
/// (fields/record/site_data.h). Every content file is proven before it is opened
/// (data/store/proven_content.h); a damaged or lost one is left out, logged, and named in
/// `SiteData::damage`, which makes a forecast degraded. A site with no data of any kind is
/// Error(not_found), one with nothing but damaged files Error(invalid_input).
[[nodiscard]] SiteData load_site_data(store::Store& store, const Site& site, UtcTime from,
                                      UtcTime to);

/// The same for a forecast with these options: the history that it wants before D, and its horizon.
[[nodiscard]] SiteData load_site_data(store::Store& store, const Site& site,
                                      const calibration::ForecastOptions& options);

/// The water depth at a site's own point by the bathymetry in the store, m; nothing where none is
/// stored there.
[[nodiscard]] std::optional<double> bathymetry_at(store::Store& store, const Site& site);

}  // namespace slackwater::api
