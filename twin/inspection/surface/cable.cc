#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/text.h"
#include "twin/inspection/surface/patched_grid.h"
#include "twin/inspection/surface/shapes.h"
#include "twin/inspection/surface/tube.h"
#include "twin/inspection/surface/usual_sizes.h"

namespace slackwater::twin {
namespace {

/// A point of the route: on the bed above the cable.
struct RoutePoint {
  Triple<double> bed_m;
  double burial_m = 0;  ///< of the cable's top
};

std::vector<RoutePoint> route_of(const CableSizes& sizes) {
  std::vector<RoutePoint> route;
  const double everywhere_m = sizes.burial_m.value_or(usual::burial_m);
  for (const CableSizes::Point& point : sizes.route)
    route.push_back({point.bed_m, point.burial_m.value_or(everywhere_m)});
  if (route.size() < 2)
    throw Unmakeable{"route", formatted("has {} points, expected at least two: where the cable "
                                        "begins and ends",
                                        route.size())};
  for (std::size_t i = 1; i < route.size(); ++i)
    if (length_of(route[i].bed_m - route[i - 1].bed_m) < 0.1)
      throw Unmakeable{"route",
                       formatted("points {} and {} are one; leave one of them out", i, i + 1)};
  return route;
}

double length_of_route(const std::vector<RoutePoint>& route) {
  double length_m = 0;
  for (std::size_t i = 1; i < route.size(); ++i)
    length_m += length_of(route[i].bed_m - route[i - 1].bed_m);
  return length_m;
}

/// Less what lies off both ends.
std::vector<RoutePoint> shortened(std::vector<RoutePoint> route, double off_m) {
  for (int end = 0; end < 2; ++end) {
    double left_m = off_m;
    while (route.size() > 2 && length_of(route[1].bed_m - route[0].bed_m) <= left_m) {
      left_m -= length_of(route[1].bed_m - route[0].bed_m);
      route.erase(route.begin());
    }
    const Triple<double> way = route[1].bed_m - route[0].bed_m;
    const double share = left_m / length_of(way);
    route[0].bed_m = route[0].bed_m + share * way;
    route[0].burial_m += share * (route[1].burial_m - route[0].burial_m);
    std::reverse(route.begin(), route.end());
  }
  return route;
}

/// A cross-section of the corridor: mitred where the route bends, so that its edges stay parallel.
struct Station {
  Triple<double> middle_m;
  Triple<double> aside;  ///< to the right of the route, from its middle to the edge
  double along_m = 0;
};

Triple<double> right_of(const Triple<double>& way) {
  const double length_m = std::hypot(way.x, way.y);
  return {-way.y / length_m, way.x / length_m, 0};
}

std::vector<Station> stations_of(const std::vector<RoutePoint>& route, double corridor_m,
                                 double patch_m) {
  std::vector<Triple<double>> aside;
  for (std::size_t i = 0; i < route.size(); ++i) {
    const Triple<double> in = right_of(route[std::max<std::size_t>(i, 1)].bed_m -
                                       route[std::max<std::size_t>(i, 1) - 1].bed_m);
    const std::size_t next = std::min(i + 1, route.size() - 1);
    const Triple<double> out = right_of(route[next].bed_m - route[next - 1].bed_m);
    const Triple<double> sum = in + out;
    // |sum|^2 = 2 (1 + cos of the bend): the mitre is as much longer as the bend is sharp.
    const double squared = dot(sum, sum);
    if (squared < 1)
      throw Unmakeable{"route", formatted("turns by more than 120 degrees at point {}; give more "
                                          "points round the bend",
                                          i + 1)};
    aside.push_back((corridor_m / squared) * sum);
  }
  std::vector<Station> stations{{route[0].bed_m, aside[0], 0}};
  for (std::size_t i = 1; i < route.size(); ++i) {
    const Triple<double> way = route[i].bed_m - route[i - 1].bed_m;
    const double length_m = length_of(way), begin_m = stations.back().along_m;
    // Neither mitre may reach beyond the other.
    const double narrow = std::min(dot(way, way) + dot(way, aside[i] - aside[i - 1]),
                                   dot(way, way) - dot(way, aside[i] - aside[i - 1]));
    if (!(narrow > 0))
      throw Unmakeable{"corridor_m", formatted("{:g} m is wider than the route's bend at point {} "
                                               "allows; take a narrower one",
                                               corridor_m, i)};
    const std::size_t pieces = pieces_in(length_m, patch_m);
    if (pieces > TooManyPatches::most_patches) throw TooManyPatches();
    for (std::size_t p = 1; p <= pieces; ++p) {
      const double share = static_cast<double>(p) / static_cast<double>(pieces);
      stations.push_back({route[i - 1].bed_m + share * way,
                          p == pieces ? aside[i] : (corridor_m / 2) * right_of(way),
                          begin_m + share * length_m});
    }
  }
  return stations;
}

}  // namespace

Surface make(const CableSizes& sizes, double patch_m) {
  std::vector<RoutePoint> route = route_of(sizes);
  const double off_ends_m = sizes.off_ends_m.value_or(0);
  const double whole_m = length_of_route(route);
  if (whole_m - 2 * off_ends_m < patch_m)
    throw Unmakeable{
        "route", formatted("is {:g} m long, of which off_ends_m leaves {:g} m, less than a patch "
                           "of {:g} m; correct it, or take a smaller patch_m",
                           whole_m, whole_m - 2 * off_ends_m, patch_m)};
  route = shortened(std::move(route), off_ends_m);
  const double corridor_m = sizes.corridor_m.value_or(usual::corridor_m);
  const double radius_m = sizes.radius_m.value_or(usual::cable_radius_m);
  const std::vector<Station> stations = stations_of(route, corridor_m, patch_m);
  SurfaceBuilder builder(route.front().bed_m);
  PatchedGrid grid;
  grid.columns = stations.size() - 1;
  grid.rows = pieces_in(corridor_m, patch_m);
  const double rows = static_cast<double>(grid.rows);
  grid.is_from_within = false;  // as on a map, with the route to the right
  grid.at = [&](double column, double row) {
    const Station& station = stations[static_cast<std::size_t>(std::lround(column))];
    return station.middle_m + (2 * row / rows - 1) * station.aside;
  };
  grid.sheet = [&](std::size_t column, std::size_t row) -> std::optional<SheetCell> {
    const double begin_m = stations[column].along_m, end_m = stations[column + 1].along_m;
    return SheetCell{0.5 * (begin_m + end_m), corridor_m * (static_cast<double>(row) + 0.5) / rows,
                     end_m - begin_m, corridor_m / rows};
  };
  (void)add_grid(builder, grid);
  // The cable itself, below the bed: it is not seen but where it lies bare.
  for (std::size_t i = 1; i < route.size(); ++i) {
    const auto axis = [&](const RoutePoint& at) {
      return at.bed_m + Triple<double>{0, 0, at.burial_m + radius_m};
    };
    add_tube(builder, {axis(route[i - 1]), axis(route[i]), radius_m}, patch_m, std::nullopt);
  }
  Sheet sheet;
  sheet.width_m = stations.back().along_m;
  sheet.height_m = corridor_m;
  sheet.along = "along the route";
  sheet.down = "across the route, from its left edge to its right one";
  return builder.finish(SurfaceKind::cable, sheet);
}

}  // namespace slackwater::twin
