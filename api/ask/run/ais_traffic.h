#pragma once
#include <span>
#include <vector>

#include "fields/geo/local_frame.h"
#include "ingest/ais/track.h"
#include "twin/traffic/traffic_picture.h"

namespace slackwater::api {

/// A track of a log on the plane of a site: NED metres from its origin at mean sea level, seconds
/// since `epoch`.
///
/// Speed and course over ground become the velocity, turned from the vessel's north to the site's
/// (their meridians meet at sin(latitude) times their difference in longitude: a degree at 80 km in
/// 55 N). A position without both, or whose speed is not zero and has no course, has no velocity.
[[nodiscard]] twin::Track track_on_site(const ingest::AisTrack& track, const LocalFrame& site,
                                        UtcTime epoch);

/// The vessels of a log as traffic around a site: those with a position within `reach_m` of its
/// origin, and of these only the positions there; base stations stand on land and are left out.
[[nodiscard]] std::vector<twin::TrafficVessel> traffic_on_site(
    std::span<const ingest::AisTrack> tracks, const LocalFrame& site, UtcTime epoch,
    double reach_m);

}  // namespace slackwater::api
