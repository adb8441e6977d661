#pragma once
#include <string>
#include <utility>
#include <vector>

#include "api/door/edr/sample/answer.h"

// What several formats say in the same words: parameters, and where an answer comes from.

namespace slackwater::api::edr {

/// A Parameter object of CoverageJSON and of EDR GeoJSON (which share it): CF standard name
/// as the id of the observed property, UCUM unit, and `measurementType.method` (EDR 1.1)
/// where there is a method.
/// @param with_id  whether the object holds its own key, as lists of parameters want it
void append_parameter(std::string& out, const Parameter& parameter, bool with_id);

/// Where the answer comes from as a JSON object; keys of api/docs/json.md.
void append_provenance(std::string& out, const Answer& answer);

/// The same as HTTP headers, for formats without a place for it (CSV): Slackwater-Site, -Instance,
/// -Issued, -Day, -Degraded, -Headline, -Attribution, -Version, -Note; of a product -Product,
/// -Dataset and -Runs instead of the first six. Bytes that are not printable ASCII, and '%', are
/// percent-encoded, so that no value can break a header. What is empty is left out; lists are
/// joined by "; ".
[[nodiscard]] std::vector<std::pair<std::string, std::string>> provenance_headers(
    const Answer& answer);
/// The names of these headers.
[[nodiscard]] std::vector<std::string> provenance_fields();

}  // namespace slackwater::api::edr
