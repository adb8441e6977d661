#pragma once
#include <string>

#include "api/door/edr/sample/answer.h"

namespace slackwater::api::edr {

/// An answer as EDR GeoJSON (`application/geo+json`): a FeatureCollection with one Point feature
/// per place, or per vertex of a trajectory, and the parameters as objects with ids.
///
/// Properties of a feature, beside those that EDR asks for (datetime, parameter-name, label,
/// edrqueryendpoint = `Answer::query_url`): `time` and `depth_m` or `height_m`, the axes as lists,
/// and for each parameter its value; a list where one of the axes has several entries, a list per
/// time of lists over levels where both have. Missing: null. Provenance stands under
/// `slackwater:provenance`. Broken promises of `Answer` are ContractViolations.
[[nodiscard]] std::string geojson(const Answer& answer);

}  // namespace slackwater::api::edr
