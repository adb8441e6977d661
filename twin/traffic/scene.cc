#include "twin/traffic/scene.h"

namespace slackwater::twin {

void populate(const std::vector<TrafficVessel>& vessels, double t_s, const TrackRule& rule,
              TrafficScene& scene) {
  scene.contacts.clear();
  scene.unheard.clear();
  for (const TrafficVessel& vessel : vessels) {
    const TrackState state = vessel.track.at(t_s, rule);
    if (state.is_known()) {
      scene.contacts.push_back({vessel.id, {state.position_m, state.velocity_m_s}});
    } else if (state.status == TrackStatus::in_gap) {
      scene.unheard.push_back(vessel.id);
    }
  }
}

}  // namespace slackwater::twin
