#pragma once
#include <string>
#include <string_view>

#include "fields/site/site.h"

namespace slackwater {

/// The file of a new site, as people go on with it: id, name, place, depth and time zone, which
/// `parse_site` reads as they were: degrees to some ten metres, the depth to 0.1 m.
/// @param depth_source  said beside the depth; of no depth a line says what to fill in
[[nodiscard]] std::string new_site_yaml(const Site& site, std::string_view depth_source);

}  // namespace slackwater
