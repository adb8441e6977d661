#include "api/ask/run/ais_traffic.h"

#include <cmath>

#include "twin/body/frame.h"

namespace slackwater::api {
namespace {

/// Unit vector of the vessel's north in the site's plane (east, north).
Horizontal north_at(const GeoPoint& point, const LocalFrame& site, const Vector3<Enu>& place) {
  constexpr double step_deg = 1e-4;  // 11 m, and away from the pole
  const double towards = point.latitude_deg() > 0 ? -step_deg : step_deg;
  const Vector3<Enu> beside =
      site.to_local(GeoPoint::from_degrees(point.latitude_deg() + towards, point.longitude_deg()));
  const Horizontal way = horizontal_of(beside - place);
  return way * std::copysign(1 / std::abs(way), towards);
}

std::optional<twin::Triple<double>> velocity_of(const ingest::AisPosition& position,
                                                const Horizontal& north) {
  if (!position.speed_over_ground_m_s) return std::nullopt;
  const double speed_m_s = *position.speed_over_ground_m_s;
  if (speed_m_s == 0) return twin::Triple<double>{};
  if (!position.course_over_ground) return std::nullopt;
  // Clockwise from the vessel's north, in a plane whose numbers turn anticlockwise.
  const Horizontal way =
      speed_m_s * north * std::polar(1.0, -position.course_over_ground->radians());
  return twin::ned_of(way);
}

twin::TrackPoint point_of(const ingest::AisPosition& position, const LocalFrame& site,
                          UtcTime epoch) {
  const Vector3<Enu> place = site.to_local(position.point);
  const Horizontal north = north_at(position.point, site, place);
  twin::TrackPoint point;
  point.t_s = seconds_between(epoch, position.time);
  point.position_m = twin::ned_of(horizontal_of(place));
  point.velocity_m_s = velocity_of(position, north);
  if (position.heading) {
    const Horizontal bow = north * std::polar(1.0, -position.heading->radians());
    point.heading_rad = std::atan2(bow.real(), bow.imag());
  }
  return point;
}

}  // namespace

twin::Track track_on_site(const ingest::AisTrack& track, const LocalFrame& site, UtcTime epoch) {
  std::vector<twin::TrackPoint> points;
  points.reserve(track.positions.size());
  for (const ingest::AisPosition& position : track.positions) {
    points.push_back(point_of(position, site, epoch));
  }
  return twin::Track(std::move(points));
}

std::vector<twin::TrafficVessel> traffic_on_site(std::span<const ingest::AisTrack> tracks,
                                                 const LocalFrame& site, UtcTime epoch,
                                                 double reach_m) {
  std::vector<twin::TrafficVessel> traffic;
  for (const ingest::AisTrack& track : tracks) {
    const bool is_on_the_water = track.speaker != ingest::AisClass::base_station &&
                                 track.speaker != ingest::AisClass::aircraft;
    if (!is_on_the_water) continue;
    ingest::AisTrack near = track;
    std::erase_if(near.positions, [&](const ingest::AisPosition& position) {
      return distance_m(position.point, site.origin()) > reach_m;
    });
    if (near.positions.empty()) continue;
    traffic.push_back({track.mmsi, track.identity.name.value_or(std::string()),
                       track.identity.length_m, track.identity.beam_m,
                       track_on_site(near, site, epoch)});
  }
  return traffic;
}

}  // namespace slackwater::api
