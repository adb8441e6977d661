#include "twin/traffic/jumps.h"

#include <cmath>

namespace slackwater::twin {
namespace {

double distance_m(const TrackPoint& a, const TrackPoint& b) {
  return std::hypot(b.position_m.x - a.position_m.x, b.position_m.y - a.position_m.y);
}

}  // namespace

SteadyPieces cut_at_jumps(std::span<const TrackPoint> points, const JumpRule& rule) {
  const auto can_follow = [&](const TrackPoint& before, const TrackPoint& after) {
    return distance_m(before, after) <=
           rule.allowance_m + rule.most_speed_m_s * (after.t_s - before.t_s);
  };
  SteadyPieces out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const bool goes_on = !out.pieces.empty() && can_follow(out.pieces.back().back(), points[i]);
    if (goes_on) {
      out.pieces.back().push_back(points[i]);
    } else if (!out.pieces.empty() && i + 1 < points.size() &&
               can_follow(out.pieces.back().back(), points[i + 1])) {
      ++out.strays;
    } else {
      out.pieces.push_back({points[i]});
    }
  }
  if (out.pieces.size() > 1) {
    const std::size_t before = out.pieces.size();
    std::erase_if(out.pieces, [](const auto& piece) { return piece.size() == 1; });
    out.strays += before - out.pieces.size();
  }
  for (std::size_t i = 1; i < out.pieces.size(); ++i) {
    const TrackPoint& from = out.pieces[i - 1].back();
    const TrackPoint& to = out.pieces[i].front();
    out.jumps.push_back({from.t_s, to.t_s, distance_m(from, to)});
  }
  return out;
}

}  // namespace slackwater::twin
