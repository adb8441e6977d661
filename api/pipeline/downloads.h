#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {

/// The exact `copernicusmarine subset` lines that fetch what a forecast of this day at this site
/// wants: currents (the finest product with tide that covers the site), waves, bathymetry and past
/// wind; with a comment line above each, and one that says where a wind forecast comes from.
[[nodiscard]] std::vector<std::string> download_lines(const ingest::ProductCatalogue& products,
                                                      const Site& site, UtcDay day,
                                                      Duration horizon);

}  // namespace slackwater::api
