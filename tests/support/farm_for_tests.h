#pragma once
#include <string>

#include "tests/support/store_for_tests.h"

namespace slackwater::tests {

/// A pile of 5 m in 30 m of water.
inline const std::string pile_yaml = R"(
water_depth_m: 30
hub_height_m: 80
landing_deg: 0
foundation: {kind: monopile, diameter_m: 5, top_height_m: 18}
)";

/// An ROV that looks at a pile: the head of an agent of a task.
inline const std::string eye_yaml = R"(agents:
  - role: eye
    kinds: [rov]
    needs: [camera]
    model: bluerov2_heavy
    speed_m_s: 0.4
    start: {distance_m: 12, depth_m: 3}
)";
/// Its work: down and up beside the pile, twice.
inline const std::string eyes_work_yaml = R"(    work:
      - {pattern: verticals, stand_off_m: 3, from: {depth_m: 4}, to: {depth_m: 9}, bearings: 2}
)";

/// The site of the test products with such a pile, the turbine T1, at its point.
/// @param more  lines of YAML beside
inline std::string farm_at_the_site(const StoreForTests& made, const std::string& more = "") {
  std::string site = read_bytes(made.site());
  const auto value_of = [&](const std::string& key) {
    const std::size_t at = site.find(key + ": ") + key.size() + 2;
    return site.substr(at, site.find('\n', at) - at);
  };
  const std::string place =
      "latitude_deg: " + value_of("latitude_deg") + ", longitude_deg: " + value_of("longitude_deg");
  for (const char* key : {"water_depth_m", "hub_height_m", "turbines"})
    if (const std::size_t at = site.find(std::string(key) + ":"); at != std::string::npos)
      site.erase(at, site.find('\n', at) + 1 - at);
  return site + pile_yaml + "turbines: [{id: T1, " + place + "}]\n" + more;
}

}  // namespace slackwater::tests
