#include "twin/traffic/laid_track.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// Half of the gap that a `TrackRule` bears.
constexpr double apart_s = 180;

/// Reports on the way from the last one to another place.
void go_on(const Triple<double>& to_m, double duration_s, std::vector<TrackPoint>& points) {
  const TrackPoint from = points.back();
  const double legs = std::max(std::ceil(duration_s / apart_s), 1.0);
  for (double k = 1; k <= legs; ++k) {
    const double u = k / legs;
    points.push_back(
        {from.t_s + u * duration_s, from.position_m + u * (to_m - from.position_m), {}, {}});
  }
}

}  // namespace

Track laid_track(std::span<const Triple<double>> places, double speed_m_s, double begin_s,
                 double end_s) {
  expects(!places.empty() && (places.size() == 1 || speed_m_s > 0),
          "a track is laid from place to place at a speed");
  std::vector<TrackPoint> points{{begin_s, places.front(), {}, {}}};
  if (places.size() == 1 && end_s > begin_s) go_on(places.front(), end_s - begin_s, points);
  for (const Triple<double>& place : places.subspan(1)) {
    const Triple<double> way = place - points.back().position_m;
    const double length_m = std::hypot(way.x, way.y);
    if (length_m > 0) go_on(place, length_m / speed_m_s, points);
  }
  return Track(std::move(points));
}

}  // namespace slackwater::twin
