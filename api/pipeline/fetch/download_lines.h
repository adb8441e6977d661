#pragma once
#include <string>
#include <vector>

#include "api/pipeline/fetch/wanted_files.h"

namespace slackwater::api {

/// The exact lines that fetch what a forecast at this site wants, each under a comment, for a
/// terminal: `copernicusmarine subset` for currents, level, waves, bathymetry and past wind, `curl`
/// for the wind forecast.
[[nodiscard]] std::vector<std::string> download_lines(const ingest::ProductCatalogue& products,
                                                      const Site& site, const WantedTimes& wanted);

/// The line of a wind forecast, under a comment; the comment alone where none is wanted.
[[nodiscard]] std::vector<std::string> gfs_wind_lines(const Site& site, UtcTime issued,
                                                      UtcTime until);

}  // namespace slackwater::api
