#include "api/door/people/playback/logged_track.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace slackwater::people {
namespace {

float between(float a, float b, double share) {
  return static_cast<float>(a + share * (static_cast<double>(b) - a));
}

/// Within half a turn to either side.
float angle_between(float a, float b, double share) {
  constexpr double turn = 2 * std::numbers::pi;
  const double way = std::remainder(static_cast<double>(b) - a, turn);
  return static_cast<float>(std::remainder(a + share * way, turn));
}

}  // namespace

Moment moment_of(std::span<const double> t_s, double at_s) noexcept {
  const auto next = std::upper_bound(t_s.begin(), t_s.end(), at_s);
  if (next == t_s.begin()) return {};
  const auto row = static_cast<std::size_t>(next - t_s.begin()) - 1;
  if (next == t_s.end()) return {row, 0};
  return {row, (at_s - t_s[row]) / (*next - t_s[row])};
}

std::optional<Pose> pose_at(std::span<const LoggedRow> rows, const Moment& moment) {
  const LoggedRow& from = rows[moment.row];
  if (!from.is_there) return std::nullopt;
  if (moment.share <= 0) return from.pose;
  const LoggedRow& to = rows[moment.row + 1];
  if (!to.is_there) return std::nullopt;
  const double share = moment.share;
  const Pose &a = from.pose, &b = to.pose;
  Pose pose = a;  // what is not between two numbers is as it was last
  pose.east_m = between(a.east_m, b.east_m, share);
  pose.north_m = between(a.north_m, b.north_m, share);
  pose.up_m = between(a.up_m, b.up_m, share);
  pose.roll_rad = angle_between(a.roll_rad, b.roll_rad, share);
  pose.pitch_rad = angle_between(a.pitch_rad, b.pitch_rad, share);
  pose.heading_rad = angle_between(a.heading_rad, b.heading_rad, share);
  pose.east_m_s = between(a.east_m_s, b.east_m_s, share);
  pose.north_m_s = between(a.north_m_s, b.north_m_s, share);
  pose.up_m_s = between(a.up_m_s, b.up_m_s, share);
  pose.current_east_m_s = between(a.current_east_m_s, b.current_east_m_s, share);
  pose.current_north_m_s = between(a.current_north_m_s, b.current_north_m_s, share);
  pose.bed_m = between(a.bed_m, b.bed_m, share);
  pose.charge = between(a.charge, b.charge, share);
  return pose;
}

}  // namespace slackwater::people
