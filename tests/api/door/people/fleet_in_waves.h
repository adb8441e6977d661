#pragma once
#include <string>

#include "tests/twin/run/run_for_tests.h"

namespace slackwater::tests {

/// Half of them ROVs, then AUVs, multirotors, WAM-Vs and crew transfer vessels, each on a way of
/// its own; in waves of 1.5 m, current and gusts.
inline std::string fleet_in_waves(int vehicles, double step_s) {
  std::string yaml = head(
      step_s,
      "{partitions: [{significant_height_m: 1.5, peak_period_s: 6, from_deg: 250}], components: "
      "64}",
      "dryden");
  struct Craft {
    const char *model, *from, *to;
  };
  constexpr Craft rov{"bluerov2_heavy", "depth_m: 5", "depth_m: 12"};
  constexpr Craft auv{"lrauv_tethys", "depth_m: 15", "depth_m: 20"};
  constexpr Craft uav{"x500", "height_m: 35", "height_m: 40"};
  constexpr Craft usv{"wamv16", "depth_m: 0", "depth_m: 0"};
  constexpr Craft ctv{"ctv24", "depth_m: 0", "depth_m: 0"};
  constexpr Craft crafts[] = {rov, auv, rov, uav, rov, usv, rov, usv, rov, ctv};
  for (int i = 0; i < vehicles; ++i) {
    const Craft& craft = crafts[i % 10];
    const std::string north = "north_m: " + std::to_string(25 * i);
    yaml += "  - {name: v" + std::to_string(i) + ", model: " + craft.model + ", start: {" + north +
            ", east_m: 0, " + craft.from + ", heading_deg: " + std::to_string(36 * i % 360) +
            "}, tasks: [{do: route, waypoints: [{" + north + ", east_m: 900, " + craft.to +
            "}]}]}\n";
  }
  return yaml;
}

}  // namespace slackwater::tests
