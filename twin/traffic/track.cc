#include "twin/traffic/track.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

bool is_finite(const Triple<double>& v) noexcept {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

double length(const Triple<double>& v) noexcept { return std::sqrt(dot(v, v)); }

bool contradicts(const Triple<double>& reported_m_s, const Triple<double>& made_m_s) noexcept {
  constexpr double noise_m_s = 0.5;
  return length(reported_m_s - made_m_s) > length(made_m_s) + noise_m_s;
}

/// Halfway headings go by the unit vectors, so that 359 and 1 degree meet at north.
std::optional<double> heading_between(const TrackPoint& before, const TrackPoint& after, double u) {
  if (!before.heading_rad || !after.heading_rad) return std::nullopt;
  const double north = (1 - u) * std::cos(*before.heading_rad) + u * std::cos(*after.heading_rad);
  const double east = (1 - u) * std::sin(*before.heading_rad) + u * std::sin(*after.heading_rad);
  constexpr double opposite = 1e-9;
  if (std::hypot(north, east) < opposite) return std::nullopt;
  return std::atan2(east, north);
}

TrackState between(const TrackPoint& before, const TrackPoint& after, double t_s,
                   TrackCurve curve) {
  const double period_s = after.t_s - before.t_s;
  const double u = (t_s - before.t_s) / period_s;
  const Triple<double> way_m = after.position_m - before.position_m;
  const Triple<double> made_m_s = (1 / period_s) * way_m;
  TrackState state;
  state.status = TrackStatus::on_track;
  state.heading_rad = heading_between(before, after, u);
  const bool is_smooth = curve == TrackCurve::smooth && before.velocity_m_s && after.velocity_m_s &&
                         !contradicts(*before.velocity_m_s, made_m_s) &&
                         !contradicts(*after.velocity_m_s, made_m_s);
  if (!is_smooth) {
    state.position_m = before.position_m + u * way_m;
    state.velocity_m_s = made_m_s;
    return state;
  }
  const Triple<double>& v0 = *before.velocity_m_s;
  const Triple<double>& v1 = *after.velocity_m_s;
  const double u2 = u * u;
  const double u3 = u2 * u;
  state.position_m = before.position_m + (3 * u2 - 2 * u3) * way_m +
                     ((u3 - 2 * u2 + u) * period_s) * v0 + ((u3 - u2) * period_s) * v1;
  state.velocity_m_s =
      (6 * u - 6 * u2) * made_m_s + (3 * u2 - 4 * u + 1) * v0 + (3 * u2 - 2 * u) * v1;
  return state;
}

}  // namespace

Track::Track(std::vector<TrackPoint> points) : points_(std::move(points)) {
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const TrackPoint& point = points_[i];
    expects(std::isfinite(point.t_s) && is_finite(point.position_m) &&
                (!point.velocity_m_s || is_finite(*point.velocity_m_s)) &&
                (!point.heading_rad || std::isfinite(*point.heading_rad)),
            "a point of a track is finite");
    expects(i == 0 || point.t_s > points_[i - 1].t_s, "the times of a track ascend");
  }
}

TrackState Track::at(double t_s, const TrackRule& rule) const noexcept {
  TrackState unknown;
  if (points_.empty() || !(t_s >= points_.front().t_s)) return unknown;
  unknown.status = TrackStatus::after_end;
  if (t_s > points_.back().t_s) return unknown;
  const auto after =
      std::upper_bound(points_.begin(), points_.end(), t_s,
                       [](double t, const TrackPoint& point) { return t < point.t_s; });
  const TrackPoint& before = *(after - 1);
  const bool is_gap = after != points_.end() && after->t_s - before.t_s > rule.longest_gap_s;
  if (after != points_.end() && !is_gap) return between(before, *after, t_s, rule.curve);
  unknown.status = TrackStatus::in_gap;
  if (t_s > before.t_s) return unknown;
  // On a report with nothing usable behind it: the leg before it, if there is one, ends here.
  if (after - points_.begin() >= 2 && before.t_s - (after - 2)->t_s <= rule.longest_gap_s) {
    return between(*(after - 2), before, t_s, rule.curve);
  }
  return {TrackStatus::on_track, before.position_m, before.velocity_m_s.value_or(Triple<double>{}),
          before.heading_rad};
}

}  // namespace slackwater::twin
