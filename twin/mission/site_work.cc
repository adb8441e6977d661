#include "twin/mission/site_work.h"

#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/error.h"
#include "fields/geo/local_frame.h"

namespace slackwater::twin {
namespace {

using constants::degree;

std::vector<MooringLine> moorings_of(const TurbinePlace& place, const WorkTurbine& at) {
  std::vector<MooringLine> lines;
  for (const Mooring& line : place.moorings) {
    const double bearing = line.bearing_deg * degree;
    lines.push_back({line.id, at.around(bearing, at.radius_m, line.fairlead_depth_m),
                     at.around(bearing, line.anchor_distance_m, at.bed_m)});
  }
  return lines;
}

WorkTurbine work_turbine_of(const Site& site, const TurbinePlace& place, const LocalFrame& frame) {
  const std::string who = "site " + site.id + ": turbine " + place.id + " ";
  WorkTurbine t;
  t.id = place.id;
  const Horizontal at = horizontal_of(frame.to_local(place.point));
  t.north_m = at.imag();
  t.east_m = at.real();
  const auto depth_m = place.water_depth_m ? place.water_depth_m : site.water_depth_m;
  if (!depth_m) refuse(who + "has no water_depth_m, and neither has the site; add one");
  if (!place.foundation)
    refuse(who +
           "has no foundation, and neither has the site; add one, as in foundation: {kind: "
           "monopile, diameter_m: 6, top_height_m: 20}");
  if (!place.landing_deg)
    refuse(who + "has no landing_deg, the bearing of its boat landing; add it");
  t.bed_m = *depth_m;
  t.radius_m = (place.foundation->kind == FoundationKind::jacket ? std::sqrt(0.5) : 0.5) *
               place.foundation->diameter_m;
  t.top_m = -place.foundation->top_height_m;
  t.foot_m =
      place.foundation->kind == FoundationKind::floating ? place.foundation->draught_m : t.bed_m;
  if (t.foot_m > t.bed_m)
    refuse(who + "is deeper than the water; correct draught_m or water_depth_m");
  if (place.hub_height_m) t.hub_m = -*place.hub_height_m;
  if (place.rotor_diameter_m) t.rotor_radius_m = 0.5 * *place.rotor_diameter_m;
  t.landing_rad = *place.landing_deg * degree;
  t.moorings = moorings_of(place, t);
  return t;
}

CableRole role_of(const Site& site, const CableRoute& cable) {
  const auto is_at_a_turbine = [&](const GeoPoint& end) {
    return std::any_of(site.turbines.begin(), site.turbines.end(),
                       [&](const TurbinePlace& place) { return place.point == end; });
  };
  return is_at_a_turbine(cable.route.front()) && is_at_a_turbine(cable.route.back())
             ? CableRole::array
             : CableRole::to_shore;
}

WorkCable work_cable_of(const Site& site, const CableRoute& cable, const LocalFrame& frame,
                        double bed_m) {
  WorkCable out;
  out.id = cable.id;
  out.burial_m = cable.burial_depth_m;
  out.role = role_of(site, cable);
  for (const GeoPoint& point : cable.route) {
    const Horizontal at = horizontal_of(frame.to_local(point));
    out.route_m.push_back({at.imag(), at.real(), bed_m});
  }
  return out;
}

}  // namespace

WorkSite work_site_of(const Site& site) {
  WorkSite work;
  const LocalFrame frame(site.point);
  if (site.turbines.empty())
    refuse("site " + site.id + ": has no turbines; add their places (`turbines`, page on sites)");
  for (const TurbinePlace& place : site.turbines)
    work.turbines.push_back(work_turbine_of(site, place, frame));
  for (const CableRoute& cable : site.cables)
    work.cables.push_back(work_cable_of(site, cable, frame, work.turbines.front().bed_m));
  return work;
}

SiteLines site_lines_of(const Site& site, const LocalFrame& frame) {
  SiteLines lines;
  for (const TurbinePlace& place : site.turbines) {
    const auto bed_m = place.water_depth_m ? place.water_depth_m : site.water_depth_m;
    if (!bed_m || !place.foundation) continue;
    WorkTurbine at;
    const Horizontal axis_m = horizontal_of(frame.to_local(place.point));
    at.north_m = axis_m.imag();
    at.east_m = axis_m.real();
    at.bed_m = *bed_m;
    at.radius_m = 0.5 * place.foundation->diameter_m;
    for (MooringLine& line : moorings_of(place, at)) {
      line.id = place.id + " " + line.id;
      lines.moorings.push_back(std::move(line));
    }
  }
  const double bed_m = site.water_depth_m.value_or(constants::nan);
  for (const CableRoute& cable : site.cables)
    lines.cables.push_back(work_cable_of(site, cable, frame, bed_m));
  return lines;
}

}  // namespace slackwater::twin
