#pragma once
#include <string>
#include <vector>

#include "fields/base/time.h"
#include "fields/site/site.h"

namespace slackwater::api {

/// The lines that fetch a forecast of the wind at 10 m about a site from `issued` to `until`: the
/// newest run of NOAA's GFS (0.25 degree, 3-hourly) that was published by then, cut by NOMADS to a
/// few cells, all steps in one GRIB file. One shell line under a comment; the comment alone where
/// the run begins after `until`.
[[nodiscard]] std::vector<std::string> gfs_wind_lines(const Site& site, UtcTime issued,
                                                      UtcTime until);

}  // namespace slackwater::api
