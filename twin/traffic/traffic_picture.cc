#include "twin/traffic/traffic_picture.h"

#include <algorithm>

namespace slackwater::twin {

void populate(const std::vector<TrafficVessel>& vessels, double t_s, const TrackRule& rule,
              TrafficPicture& picture) {
  picture.contacts.clear();
  picture.unheard.clear();
  for (const TrafficVessel& vessel : vessels) {
    if (!vessel.is_around) continue;
    const TrackState state = vessel.track.at(t_s, rule);
    if (state.is_known()) {
      picture.contacts.push_back({vessel.id, {state.position_m, state.velocity_m_s}});
    } else if (state.status == TrackStatus::in_gap) {
      picture.unheard.push_back(vessel.id);
    }
  }
}

std::string name_of_vessel(std::span<const TrafficVessel> vessels, std::uint32_t mmsi) {
  const auto found = std::find_if(vessels.begin(), vessels.end(),
                                  [&](const TrafficVessel& vessel) { return vessel.id == mmsi; });
  return found == vessels.end() ? std::string() : found->name;
}

}  // namespace slackwater::twin
