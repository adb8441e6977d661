#include "twin/traffic/traffic_picture.h"

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

}  // namespace slackwater::twin
