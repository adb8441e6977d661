#include "api/door/people/wire/counted_pose.h"

#include <cmath>

namespace slackwater::people {
namespace {

constexpr double speeds = 100, places = 200, depths = 20, shares = 2000;  // steps to the unit
constexpr double angles = 2607.5945876176133;                             // 16384 / (2 pi)

/// Counts the numbers of a pose, and minds that each can be counted.
struct Counter {
  CountedPose& pose;
  std::size_t next = 0;
  void operator()(double value, double steps) noexcept {
    const double count = std::floor(value * steps + 0.5);
    const bool is_countable = std::fabs(count) <= CountedPose::most;  // and a number
    pose.is_countable = pose.is_countable && is_countable;
    pose.n[next++] = is_countable ? static_cast<std::int32_t>(count) : 0;
  }
  /// Nothing where it is no number.
  void if_known(bool& is_known, double value, double steps) noexcept {
    is_known = !std::isnan(value);
    (*this)(is_known ? value : 0, steps);
  }
};

}  // namespace

std::int32_t wrapped(std::int64_t angle) noexcept {
  constexpr std::int64_t turn = CountedPose::turn;
  const std::int64_t within = ((angle + turn / 2) % turn + turn) % turn;
  return static_cast<std::int32_t>(within - turn / 2);
}

CountedPose counted(const Pose& pose) noexcept {
  CountedPose is;
  is.is_countable = true;
  is.is_halted = pose.is_halted;
  is.vehicle = pose.vehicle;
  Counter count{is};
  count(pose.east_m_s, speeds);
  count(pose.north_m_s, speeds);
  count(pose.up_m_s, speeds);
  count(pose.roll_rad, angles);
  count(pose.pitch_rad, angles);
  count(pose.heading_rad, angles);
  for (std::size_t i = CountedPose::angles; i < CountedPose::places; ++i)
    is.n[i] = wrapped(is.n[i]);
  count(pose.east_m, places);
  count(pose.north_m, places);
  count(pose.up_m, places);
  count(pose.current_east_m_s, speeds);
  count(pose.current_north_m_s, speeds);
  count.if_known(is.has_bed, static_cast<double>(pose.up_m) - static_cast<double>(pose.bed_m),
                 depths);
  count.if_known(is.has_charge, pose.charge, shares);
  return is;
}

}  // namespace slackwater::people
