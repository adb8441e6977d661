#include "twin/traffic/deviation.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

/// A corner of the way.
struct Corner {
  double north_m = 0;
  double east_m = 0;
  double along_m = 0;  ///< from the start
  double t_s = 0;
};

std::vector<Corner> way_of(const Track& track, const TrackRule& rule) {
  constexpr double piece_s = 1;
  constexpr double most_pieces = 1000;
  std::vector<Corner> way;
  const auto add = [&](const Triple<double>& position, double t_s) {
    const double step =
        way.empty() ? 0
                    : std::hypot(position.x - way.back().north_m, position.y - way.back().east_m);
    way.push_back({position.x, position.y, way.empty() ? 0 : way.back().along_m + step, t_s});
  };
  const auto points = track.points();
  add(points.front().position_m, points.front().t_s);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double period_s = points[i].t_s - points[i - 1].t_s;
    const double pieces = period_s > rule.longest_gap_s
                              ? 1  // straight across a gap: nobody is compared there
                              : std::clamp(std::ceil(period_s / piece_s), 1.0, most_pieces);
    for (double k = 1; k < pieces; ++k) {
      const double t_s = points[i - 1].t_s + period_s * k / pieces;
      add(track.at(t_s, rule).position_m, t_s);
    }
    add(points[i].position_m, points[i].t_s);
  }
  return way;
}

/// How far along the way the track is at a time it knows.
double along_at(const std::vector<Corner>& way, double t_s) {
  const auto after = std::upper_bound(
      way.begin(), way.end(), t_s, [](double t, const Corner& corner) { return t < corner.t_s; });
  if (after == way.end()) return way.back().along_m;
  const Corner& before = *(after - 1);
  const double u = (t_s - before.t_s) / (after->t_s - before.t_s);
  return before.along_m + u * (after->along_m - before.along_m);
}

struct Place {
  double across_m = 0;
  double along_m = 0;  ///< from the start of the way
};

Place nearest_place(const std::vector<Corner>& way, const Triple<double>& position, double from_m,
                    double to_m) {
  const double length_m = way.back().along_m;
  Place best{std::hypot(position.x - way.front().north_m, position.y - way.front().east_m), 0};
  if (!(length_m > 0)) return best;
  double least = HUGE_VAL;
  auto corner = std::lower_bound(way.begin() + 1, way.end(), from_m,
                                 [](const Corner& c, double along) { return c.along_m < along; });
  // The window may lie beyond an end, at a piece without length: the piece with length next to it
  // is meant.
  if (corner == way.end()) --corner;
  while (corner != way.begin() + 1 && !(corner->along_m > (corner - 1)->along_m)) --corner;
  for (; corner != way.end() && (corner - 1)->along_m <= to_m; ++corner) {
    const Corner& a = *(corner - 1);
    const double piece_m = corner->along_m - a.along_m;
    if (!(piece_m > 0)) continue;
    const double north = (corner->north_m - a.north_m) / piece_m;
    const double east = (corner->east_m - a.east_m) / piece_m;
    const double off_north = position.x - a.north_m;
    const double off_east = position.y - a.east_m;
    const double least_m = a.along_m > 0 ? 0 : -HUGE_VAL;
    const double most_m = corner->along_m < length_m ? piece_m : HUGE_VAL;
    const double along = std::clamp(off_north * north + off_east * east, least_m, most_m);
    const double distance = std::hypot(off_north - along * north, off_east - along * east);
    if (distance >= least) continue;
    least = distance;
    best = {std::copysign(distance, north * off_east - east * off_north), a.along_m + along};
  }
  return best;
}

/// Sums for the statistics of one signed distance.
class Tally {
 public:
  void add(double value) {
    sum_ += value;
    squares_ += value * value;
    most_ = std::max(most_, std::abs(value));
  }
  [[nodiscard]] DistanceStatistics of(std::size_t samples) const {
    if (samples == 0) return {};
    const auto n = static_cast<double>(samples);
    return {sum_ / n, std::sqrt(squares_ / n), most_};
  }

 private:
  double sum_ = 0;
  double squares_ = 0;
  double most_ = 0;
};

}  // namespace

Deviation deviation_from(const Track& track, const TrackRule& rule,
                         std::span<const FollowedPoint> followed, double window_m,
                         double within_m) {
  expects(!track.points().empty(), "a way has at least one point");
  const std::vector<Corner> way = way_of(track, rule);
  Deviation deviation;
  Tally across;
  Tally along;
  Tally apart;
  for (const FollowedPoint& point : followed) {
    const TrackState wanted = track.at(point.t_s, rule);
    if (!wanted.is_known()) {
      ++deviation.unknown;
      continue;
    }
    const double apart_m = std::hypot(point.position_m.x - wanted.position_m.x,
                                      point.position_m.y - wanted.position_m.y);
    const double wanted_m = along_at(way, point.t_s);
    const double reach_m = std::min(window_m, 4 * apart_m + 20);
    const Place place =
        nearest_place(way, point.position_m, wanted_m - reach_m, wanted_m + reach_m);
    ++deviation.samples;
    deviation.within += apart_m < within_m ? 1U : 0U;
    apart.add(apart_m);
    across.add(place.across_m);
    along.add(way.back().along_m > 0 ? place.along_m - wanted_m : 0);
  }
  deviation.across = across.of(deviation.samples);
  deviation.along = along.of(deviation.samples);
  deviation.apart = apart.of(deviation.samples);
  return deviation;
}

}  // namespace slackwater::twin
