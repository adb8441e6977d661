#include "twin/clearance/read_stand_off.h"

namespace slackwater::twin {

StandOff read_stand_off(const Config& c) {
  StandOff s;
  const auto take = [&](std::string_view key, double most_m, double& value) {
    value = c.optional_number(key, {0, most_m}).value_or(value);
  };
  take("craft_m", 1000, s.craft_m);
  take("structure_m", 1000, s.structure_m);
  take("tether_m", 100, s.tether_m);
  take("vessel_m", 5000, s.vessel_m);
  take("vertical_m", 500, s.vertical_m);
  return s;
}

}  // namespace slackwater::twin
