#include "api/ask/rehearse/zones.h"

#include "fields/geo/local_frame.h"

namespace slackwater::api {
namespace {

Horizontal plane_of(const twin::Triple<double>& at_m) { return {at_m.y, at_m.x}; }

/// At any whole hour of the mission, or at its end.
bool is_in_force(const ConstraintArea& area, UtcTime start, double duration_s) {
  const UtcTime end = start + Duration(static_cast<Duration::rep>(duration_s * 1000));
  for (UtcTime time = start; time < end; time += std::chrono::minutes(30))
    if (area.is_in_force(time)) return true;
  return area.is_in_force(end);
}

bool counts_at(const ConstraintArea& area, const twin::Triple<double>& at_m) {
  return !area.below_height_m || -at_m.z < *area.below_height_m;
}

/// Empty where it keeps out.
std::string trespass(const twin::ScenarioVehicle& vehicle, const ConstraintArea& area,
                     const std::vector<Horizontal>& corners) {
  const std::string zone =
      "zone " + area.id + (area.reason.empty() ? "" : " (" + area.reason + ")") + ", in force then";
  if (counts_at(area, vehicle.start_m) && is_inside(corners, plane_of(vehicle.start_m)))
    return vehicle.name + ": starts in " + zone;
  twin::Triple<double> before_m = vehicle.start_m;
  for (const twin::ScenarioTask& task : vehicle.tasks)
    for (const twin::Waypoint& at : task.waypoints) {
      const bool counts = counts_at(area, before_m) || counts_at(area, at.position_m);
      if (counts && leads_through(corners, plane_of(before_m), plane_of(at.position_m)))
        return vehicle.name + ": its way leads through " + zone;
      before_m = at.position_m;
    }
  return "";
}

}  // namespace

std::string zone_in_the_way(const LoadedMission& mission, UtcTime start) {
  const LocalFrame frame(mission.scenario.origin);
  for (const ConstraintArea& area : mission.areas) {
    if (area.kind != AreaKind::exclusion || !is_in_force(area, start, mission.scenario.duration_s))
      continue;
    std::vector<Horizontal> corners;
    for (const GeoPoint& corner : area.corners)
      corners.push_back(horizontal_of(frame.to_local(corner)));
    for (const twin::ScenarioVehicle& vehicle : mission.scenario.vehicles)
      if (std::string why = trespass(vehicle, area, corners); !why.empty()) return why;
  }
  return "";
}

}  // namespace slackwater::api
