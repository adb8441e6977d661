#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/site/site.h"
#include "ingest/copernicus/product_catalogue.h"

namespace slackwater::api {

/// Of which times the inputs of a forecast are wanted.
struct WantedTimes {
  UtcDay day;        ///< D
  UtcTime issued;    ///< when the forecast is issued: whose run of the wind there is by then
  Duration horizon;  ///< how far beyond the end of D
  Duration history = std::chrono::days(3);  ///< how long before D: three days for the tide
};

/// The exact lines that fetch what a forecast at this site wants, each under a comment:
/// `copernicusmarine subset` for currents, level, waves, bathymetry and past wind, each of the
/// product with tide, else the finest, that has water there; `curl` for the wind forecast
/// (api/pipeline/ingest/gfs_download.h).
[[nodiscard]] std::vector<std::string> download_lines(const ingest::ProductCatalogue& products,
                                                      const Site& site, const WantedTimes& wanted);

}  // namespace slackwater::api
