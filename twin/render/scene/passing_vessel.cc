#include "twin/render/scene/passing_vessel.h"

#include <algorithm>
#include <cmath>

#include "fields/base/text.h"
#include "twin/render/scene/simple_mesh.h"

namespace slackwater::twin {
namespace {

constexpr double usual_length_m = 20, usual_slenderness = 5, usual_beam_m = 6;
constexpr double draught = 0.05, freeboard = 0.1;  // of the length
constexpr double still_m_s = 0.2;                  // slower ones swing at anchor

Rotation<double> upright(const Triple<double>& velocity_m_s) {
  EulerAngles angles;
  if (std::hypot(velocity_m_s.x, velocity_m_s.y) > still_m_s)
    angles.yaw_rad = std::atan2(velocity_m_s.y, velocity_m_s.x);
  return rotation_of(attitude_of(angles));
}

}  // namespace

SeenThing seen_vessel(const TrafficVessel& vessel, const MovingPoint& motion, double surface_m) {
  const double length_m = vessel.length_m.value_or(usual_length_m);
  const double beam_m =
      vessel.beam_m.value_or(vessel.length_m ? length_m / usual_slenderness : usual_beam_m);
  const double height_m = (draught + freeboard) * length_m;
  const Triple<double> middle_m{motion.position_m.x, motion.position_m.y,
                                surface_m + draught * length_m - 0.5 * height_m};
  return {vessel.name.empty() ? formatted("vessel {}", vessel.id) : vessel.name, SeenClass::vessel,
          Material::grey_paint,
          hull_mesh(VehicleKind::vessel, {length_m, beam_m, height_m}, middle_m,
                    upright(motion.velocity_m_s))};
}

std::vector<SeenThing> vessels_in_reach(const std::vector<TrafficVessel>& vessels, double t_s,
                                        const Triple<double>& middle_m, double reach_m,
                                        double surface_m) {
  TrafficPicture picture;
  populate(vessels, t_s, {}, picture);
  std::vector<SeenThing> seen;
  for (const Contact& contact : picture.contacts) {
    const Triple<double>& at_m = contact.motion.position_m;
    if (std::hypot(at_m.x - middle_m.x, at_m.y - middle_m.y) > reach_m) continue;
    const auto vessel = std::find_if(vessels.begin(), vessels.end(), [&](const TrafficVessel& one) {
      return one.id == contact.id;
    });
    if (vessel != vessels.end()) seen.push_back(seen_vessel(*vessel, contact.motion, surface_m));
  }
  return seen;
}

}  // namespace slackwater::twin
