#include "api/ask/plan/sea_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "fields/geo/local_frame.h"

namespace slackwater::api {
namespace {

constexpr double off_m = 50;

using Polygon = std::vector<Horizontal>;

double cross_of(Horizontal a, Horizontal b) { return a.real() * b.imag() - a.imag() * b.real(); }

double twice_area(const Polygon& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += cross_of(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

/// The corners, each moved out of the polygon by as much.
Polygon corners_off(const Polygon& corners) {
  const double turn = twice_area(corners) > 0 ? 1 : -1;  // counter-clockwise, or not
  const std::size_t n = corners.size();
  Polygon off;
  for (std::size_t i = 0; i < n; ++i) {
    const Horizontal in = corners[i] - corners[(i + n - 1) % n];
    const Horizontal out = corners[(i + 1) % n] - corners[i];
    // Right of a way round counter-clockwise is outside.
    const Horizontal right(0, -turn);
    const Horizontal away = in / std::abs(in) * right + out / std::abs(out) * right;
    const double size = std::abs(away);
    off.push_back(corners[i] + (size > 1e-6 ? away / size : in / std::abs(in)) * off_m);
  }
  return off;
}

bool is_free(const std::vector<Polygon>& polygons, Horizontal a, Horizontal b) {
  return std::none_of(polygons.begin(), polygons.end(),
                      [&](const Polygon& one) { return leads_through(one, a, b); });
}

}  // namespace

double sea_way_m(const GeoPoint& from, const GeoPoint& to,
                 const std::vector<ConstraintArea>& areas) {
  const double straight_m = distance_m(from, to);
  if (areas.empty()) return straight_m;
  const LocalFrame frame(from);
  std::vector<Polygon> polygons;
  std::vector<Horizontal> nodes{{0, 0}, horizontal_of(frame.to_local(to))};
  for (const ConstraintArea& area : areas) {
    Polygon corners;
    for (const GeoPoint& corner : area.corners)
      corners.push_back(horizontal_of(frame.to_local(corner)));
    const Polygon off = corners_off(corners);
    nodes.insert(nodes.end(), off.begin(), off.end());
    polygons.push_back(std::move(corners));
  }
  if (is_free(polygons, nodes[0], nodes[1])) return straight_m;
  // Dijkstra over what sees each other.
  const double never = std::numeric_limits<double>::infinity();
  std::vector<double> far(nodes.size(), never);
  std::vector<bool> is_done(nodes.size(), false);
  far[0] = 0;
  for (;;) {
    std::size_t at = nodes.size();
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!is_done[i] && far[i] < never && (at == nodes.size() || far[i] < far[at])) at = i;
    if (at == nodes.size() || at == 1) break;
    is_done[at] = true;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      if (!is_done[i] && is_free(polygons, nodes[at], nodes[i]))
        far[i] = std::min(far[i], far[at] + std::abs(nodes[i] - nodes[at]));
  }
  return far[1] < never ? std::max(far[1], straight_m) : straight_m;
}

std::vector<ConstraintArea> closed_areas(const std::vector<ConstraintArea>& areas, UtcTime begin,
                                         UtcTime end) {
  std::vector<ConstraintArea> closed;
  for (const ConstraintArea& area : areas) {
    bool is_closed = false;
    for (UtcTime time = begin; time < end && !is_closed; time += std::chrono::minutes(30))
      is_closed = area.is_in_force(time);
    if (area.kind == AreaKind::exclusion && is_closed) closed.push_back(area);
  }
  return closed;
}

}  // namespace slackwater::api
