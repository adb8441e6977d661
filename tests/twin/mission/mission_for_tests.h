#pragma once
#include <map>

#include "tests/support/shared_data.h"
#include "twin/scenario/expand_mission.h"

namespace slackwater::tests {

/// A farm of two monopiles 700 m apart and a floating turbine, in 35 m and 90 m of water.
inline twin::WorkSite small_farm() {
  twin::WorkSite site;
  twin::WorkTurbine pile;
  pile.id = "A01";
  pile.bed_m = pile.foot_m = 35;
  pile.radius_m = 3;
  pile.top_m = -20;
  pile.hub_m = -90;
  pile.rotor_radius_m = 63;
  pile.landing_rad = 3.141592653589793;
  site.turbines.push_back(pile);
  pile.id = "A02";
  pile.north_m = 100;
  pile.east_m = 700;
  site.turbines.push_back(pile);
  twin::WorkTurbine floating = pile;
  floating.id = "F01";
  floating.north_m = 3000;
  floating.east_m = 0;
  floating.foot_m = 20;
  floating.moorings.push_back({"M1", {3006, 0, 14}, {3250, 0, 33}});
  site.turbines.push_back(floating);
  site.cables.push_back({"A01-A02", {{0, 0, 35}, {60, 350, 35}, {100, 700, 35}}, 1});
  return site;
}

inline twin::MissionParts small_farm_parts() {
  twin::MissionParts parts;
  parts.site = small_farm();
  parts.task = [](const std::string& id) {
    return Config::load(source_folder() / "data" / "tasks" / (id + ".yaml"));
  };
  return parts;
}

}  // namespace slackwater::tests
