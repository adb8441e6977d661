#pragma once
#include <string>

#include "fields/geo/geo_point.h"
#include "ingest/cf/trajectory_file.h"

// What an inspection found, for maps and spreadsheets. A false alarm is reported like a finding:
// whoever flies cannot tell. Only the truth, where it is asked for, tells them apart, with what was
// missed.

namespace slackwater::api {

struct FindingsChoice {
  bool shows_truth = false;
};

/// RFC 7946: a Point a finding, WGS 84, without a third coordinate, which would be a height above
/// the ellipsoid; `depth_m` below mean sea level (negative: above) stands among the properties, all
/// with their units: number, kind, surface, instrument, vehicle, bearing_deg (round an upright
/// axis; else null), along_m and down_m on the sheet, size_m, severity and its unit, detail_m (a
/// size is known no better), time (UTC, of the evidence). With the truth: truth, true_size_m,
/// size_error_m, position_error_m, true_severity; a value that is not there is null.
/// @throws Error(invalid_input) where the log holds no inspection, a damaged one or no origin
[[nodiscard]] std::string findings_geojson(const ingest::TrajectoryFile& log,
                                           const FindingsChoice& choice = {});

/// The same, a row each, with latitude_deg and longitude_deg; a value that is not there is empty.
[[nodiscard]] std::string findings_csv(const ingest::TrajectoryFile& log,
                                       const FindingsChoice& choice = {});

/// Where (0, 0, 0) of a log lies: its attribute `origin`, "48.850000000 N, -2.550000000 E".
/// @throws Error(invalid_input)
[[nodiscard]] GeoPoint origin_in(const ingest::TrajectoryFile& log);

}  // namespace slackwater::api
