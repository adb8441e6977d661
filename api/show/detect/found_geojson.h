#pragma once
#include <string>

#include "api/ask/detect/run_finds.h"
#include "fields/geo/geo_point.h"

namespace slackwater::api {

/// Who looked, for those who read what was found.
struct WhoLooked {
  std::string detector;
  std::string sensor;
  std::string vehicle;
  GeoPoint origin;  ///< of the run's (0, 0, 0)
};

/// What a detector found on a run, as RFC 7946: a Point a finding, with the properties that
/// `simulate --findings` has where there is one of the kind (number, kind, surface, instrument,
/// vehicle, east_m, north_m, depth_m, size_m, time_utc), and of its own: detector, confidence,
/// range_m, pictures; truth ("found" or "false alarm") and defect, its number, where asked for.
[[nodiscard]] std::string found_geojson(const RunFinds& finds, const WhoLooked& who,
                                        bool shows_truth);

}  // namespace slackwater::api
