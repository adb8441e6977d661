#include "api/door/live/topics/site_publisher.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"
#include "fields/base/turn.h"
#include "twin/traffic/closest_approach.h"

namespace slackwater::live {
namespace {

constexpr double power_every_s = 60, traffic_every_s = 2;

/// The nearest of the approaches that are foreseen to any vehicle that goes on.
twin::ClosestApproach nearest_of(const twin::MovingPoint& vessel,
                                 std::span<const twin::Seen> vehicles) {
  constexpr double none = constants::nan;
  twin::ClosestApproach nearest{none, none, false};
  for (const twin::Seen& vehicle : vehicles) {
    if (vehicle.halt != twin::Halt::none) continue;
    const auto approach =
        twin::closest_approach({vehicle.position_m, vehicle.velocity_m_s}, vessel);
    if (!(approach.distance_m >= nearest.distance_m)) nearest = approach;
  }
  return nearest;
}

}  // namespace

SitePublisher::SitePublisher(Stream& stream, const RunPlace& place, const std::string& site,
                             const twin::Environment& environment,
                             std::span<const twin::TrafficVessel> vessels)
    : stream_(stream),
      place_(place),
      environment_(environment),
      sampler_(environment),
      vessels_(vessels.begin(), vessels.end()),
      water_(stream, site) {
  clock_ = stream.open("/clock", "rosgraph_msgs/msg/Clock", clock_quality);
  power_ =
      stream.open("/" + site + "/turbine_power", "std_msgs/msg/Float64MultiArray", latched_quality);
  ais_ = stream.open("/ais", "slackwater_msgs/msg/AisTarget", {true, false, 100});
}

void SitePublisher::speak(std::span<const twin::Seen> vehicles, double t_s) {
  const dds::Stamp stamp = dds::stamp_of(place_.epoch, t_s);
  if (stream_.is_wanted(clock_)) stream_.publish(clock_, stamp, dds::clock(stamp));
  water_.speak({*environment_.field, environment_.member, place_.origin}, sampler_.sea({}, t_s),
               stamp, t_s);
  if (is_due(t_s, power_every_s, power_s_)) speak_of_turbines(stamp);
  if (!vessels_.empty() && is_due(t_s, traffic_every_s, traffic_s_) && stream_.is_wanted(ais_))
    speak_of_traffic(vehicles, t_s, stamp);
}

void SitePublisher::speak_of_turbines(const dds::Stamp& stamp) {
  std::vector<double> power_w;
  if (environment_.farm)
    for (const TurbineFlow& turbine : environment_.farm->turbines())
      power_w.push_back(turbine.power_w);
  stream_.publish(power_, stamp, dds::turbine_power(power_w));
}

void SitePublisher::speak_of_traffic(std::span<const twin::Seen> vehicles, double t_s,
                                     const dds::Stamp& stamp) {
  twin::populate(vessels_, t_s, {}, picture_);
  const twin::DegreesPerMetre per_m = twin::degrees_per_metre(place_.origin);
  for (const twin::Contact& contact : picture_.contacts) {
    const auto vessel = std::find_if(vessels_.begin(), vessels_.end(),
                                     [&](const auto& other) { return other.id == contact.id; });
    const twin::Triple<double>& at_m = contact.motion.position_m;
    const twin::Triple<double>& v = contact.motion.velocity_m_s;
    const twin::ClosestApproach nearest = nearest_of(contact.motion, vehicles);
    dds::AisTarget target;
    target.mmsi = contact.id;
    if (vessel != vessels_.end()) target.name = vessel->name;
    // Far off, the plane of the run goes beyond the pole, and no vessel is there.
    const double latitude_deg = place_.origin.latitude_deg() + at_m.x * per_m.north;
    const double longitude_deg = place_.origin.longitude_deg() + at_m.y * per_m.east;
    if (!(std::abs(latitude_deg) <= 90) || !std::isfinite(longitude_deg)) continue;
    target.point = GeoPoint::from_degrees(latitude_deg, longitude_deg);
    target.speed_m_s = std::hypot(v.x, v.y);
    target.course_deg = compass_deg(std::atan2(v.y, v.x) * 180 / constants::pi);
    target.cpa_m = nearest.distance_m;
    target.tcpa_s = nearest.time_s;
    stream_.publish(ais_, stamp, dds::ais_target(target, stamp));
  }
}

}  // namespace slackwater::live
