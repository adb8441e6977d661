#include "twin/inspection/instrument/pose.h"

#include <algorithm>
#include <cmath>

#include "fields/base/constants.h"

namespace slackwater::twin {
namespace {

constexpr double slight = 1e-9;

/// a x b as a unit vector, or `other` where they are nearly parallel.
Triple<double> unit_across(const Triple<double>& a, const Triple<double>& b,
                           const Triple<double>& other) noexcept {
  const Triple<double> across = cross(a, b);
  const double length = length_of(across);
  return length > 1e-6 ? (1 / length) * across : other;
}

bool is_fan(const Instrument& instrument) noexcept {
  return std::holds_alternative<FanFootprint>(instrument.footprint);
}

double half_step_m(const FrameFootprint& frame, double range_m) noexcept {
  return range_m * std::tan(std::min(frame.horizontal_rad, frame.vertical_rad) / 2);
}
double half_step_m(const FanFootprint& fan, double range_m) noexcept {
  return range_m * std::min(0.5, std::tan(std::min(fan.across_rad, constants::pi / 2) / 2));
}
double half_step_m(const SpotFootprint& spot, double /*range_m*/) noexcept {
  return spot.spot_m / 2;
}
double half_step_m(const RoundFootprint& /*round*/, double range_m) noexcept {
  return range_m / 10;
}

/// How what is kept on the nearest place turns: as the normal there does.
Triple<double> turning_with_aim(const Pose& pose, const AimedAt& target) noexcept {
  const Bend& bend = target.bend;
  const double off_m = std::max(0.0, dot(pose.position_m - target.place_m, bend.normal));
  const auto along = [&](const Triple<double>& way, double per_m) {
    constexpr double least = 0.2;
    const double wider = 1 + off_m * per_m;
    const double rate = wider < least ? 0 : per_m * dot(pose.velocity_m_s, way) / wider;
    return rate * cross(bend.normal, way);
  };
  return along(bend.first, bend.first_per_m) + along(bend.second, bend.second_per_m);
}

/// What keeps a picture level meanwhile: a turn about its own axis.
Triple<double> turning_level(const Pose& pose) noexcept {
  constexpr double nearly_upright = 0.05;
  const Triple<double> down = cross(pose.axis, pose.right);
  if (std::abs(down.z) < nearly_upright) return {};
  const double level = dot(pose.turning_rad_s, down) * pose.axis.z / down.z;
  return (level - dot(pose.turning_rad_s, pose.axis)) * pose.axis;
}

}  // namespace

Pose pose_of(const Instrument& instrument, const Carriage& carriage,
             const AimedAt& target) noexcept {
  const Rotation<double>& r = carriage.attitude;
  const Triple<double> arm_m = r.to_ned(instrument.position_m);
  const Triple<double> turning = r.to_ned(carriage.rates_rad_s);
  const Triple<double> bow = r.to_ned({1, 0, 0});
  const Triple<double> starboard = r.to_ned({0, 1, 0});
  Pose pose;
  pose.position_m = carriage.position_m + arm_m;
  pose.velocity_m_s = carriage.velocity_m_s + cross(turning, arm_m);
  if (instrument.aim == Aim::fixed) {
    pose.axis = r.to_ned(instrument.axis);
    pose.right = is_fan(instrument) ? unit_across(pose.axis, bow, starboard)
                                    : unit_across(r.to_ned({0, 0, 1}), pose.axis, starboard);
    pose.turning_rad_s = turning;
    return pose;
  }
  const Triple<double> way = target.place_m - pose.position_m;
  const double range_m = length_of(way);
  pose.axis = range_m > slight ? (1 / range_m) * way : bow;
  const Triple<double> level =
      unit_across({0, 0, 1}, pose.axis, unit_across(pose.axis, bow, starboard));
  pose.right = level;
  pose.turning_rad_s = turning_with_aim(pose, target);
  if (!is_fan(instrument)) {
    pose.turning_rad_s = pose.turning_rad_s + turning_level(pose);
  } else {
    const Triple<double> aside = pose.velocity_m_s - dot(pose.velocity_m_s, pose.axis) * pose.axis;
    constexpr double hardly_moves_m_s = 1e-3;
    if (length_of(aside) > hardly_moves_m_s) pose.right = unit_across(pose.axis, aside, level);
  }
  return pose;
}

double step_between_looks_m(const Instrument& instrument, double range_m) noexcept {
  if (std::holds_alternative<RoundFootprint>(instrument.footprint))
    range_m = instrument.most_range_m;
  return std::visit([&](const auto& footprint) { return half_step_m(footprint, range_m); },
                    instrument.footprint);
}

}  // namespace slackwater::twin
