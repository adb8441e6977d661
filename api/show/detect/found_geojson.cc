#include "api/show/detect/found_geojson.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "fields/base/time.h"
#include "fields/geo/local_frame.h"

namespace slackwater::api {
namespace {

/// To a tenth of a millimetre, and on the ground to a centimetre (findings_file.cc).
double rounded(double value) { return std::round(value * 1e4) / 1e4; }
double rounded_degrees(double degrees) { return std::round(degrees * 1e7) / 1e7; }

}  // namespace

std::string found_geojson(const RunFinds& finds, const WhoLooked& who, bool shows_truth) {
  using json = nlohmann::ordered_json;
  const LocalFrame frame(who.origin);
  json features = json::array();
  for (const RunFinding& one : finds.findings()) {
    const Vector3<Enu> enu_m(one.place_m.y, one.place_m.x, -one.place_m.z);
    const GeoPoint place = frame.to_geodetic(enu_m).point;
    json properties = {{"number", features.size() + 1},   {"kind", one.of},
                       {"surface", one.surface},          {"instrument", who.sensor},
                       {"vehicle", who.vehicle},          {"east_m", rounded(enu_m.x())},
                       {"north_m", rounded(enu_m.y())},   {"depth_m", rounded(-enu_m.z())},
                       {"size_m", rounded(one.size_m)},   {"time_utc", format_utc(one.time)},
                       {"detector", who.detector},        {"confidence", rounded(one.confidence)},
                       {"range_m", rounded(one.range_m)}, {"pictures", one.pictures}};
    if (shows_truth) {
      properties["truth"] = one.defect ? "found" : "false alarm";
      properties["defect"] = one.defect ? json(*one.defect) : json(nullptr);
    }
    features.push_back(
        {{"type", "Feature"},
         {"geometry",
          {{"type", "Point"},
           {"coordinates",
            {rounded_degrees(place.longitude_deg()), rounded_degrees(place.latitude_deg())}}}},
         {"properties", std::move(properties)}});
  }
  const json all = {{"type", "FeatureCollection"}, {"features", std::move(features)}};
  return all.dump(1, ' ', false, json::error_handler_t::replace) + "\n";
}

}  // namespace slackwater::api
