#pragma once
#include <vector>

#include "twin/run/command.h"

namespace slackwater::live {

/// A list of places as clients give it, at the vehicle's own speed. @param places_m  NED
[[nodiscard]] inline twin::Reroute reroute_to(const std::vector<twin::Triple<double>>& places_m,
                                              bool loop = false) {
  twin::Reroute reroute;
  reroute.loop = loop;
  for (const auto& place_m : places_m) reroute.waypoints.push_back({place_m});
  return reroute;
}

}  // namespace slackwater::live
