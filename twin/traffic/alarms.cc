#include "twin/traffic/alarms.h"

#include <algorithm>
#include <cmath>

#include "fields/base/check.h"

namespace slackwater::twin {
namespace {

double range_m(const MovingPoint& own, const MovingPoint& other) noexcept {
  return std::hypot(other.position_m.x - own.position_m.x, other.position_m.y - own.position_m.y);
}

}  // namespace

std::vector<Alarm> alarms(const MovingPoint& own, std::span<const Contact> traffic,
                          const AlarmLimits& limits, std::span<const Alarm> previous) {
  expects(limits.distance_m > 0 && limits.time_s > 0 && limits.hold_factor >= 1,
          "the limits of an alarm are positive");
  const auto was_alarm = [&](std::uint32_t id) {
    return std::any_of(previous.begin(), previous.end(), [&](const Alarm& alarm) {
      return alarm.id == id && alarm.status != AlarmStatus::lost;
    });
  };
  std::vector<Alarm> result;
  for (const Contact& contact : traffic) {
    const bool is_held = was_alarm(contact.id);
    const double factor = is_held ? limits.hold_factor : 1;
    const ClosestApproach approach = closest_approach(own, contact.motion);
    const double reach_m = factor * limits.distance_m;
    const bool will_be_near =
        approach.distance_m < reach_m && approach.time_s < factor * limits.time_s;
    if (will_be_near || range_m(own, contact.motion) < reach_m) {
      result.push_back({contact.id, is_held ? AlarmStatus::held : AlarmStatus::raised, approach});
    }
  }
  for (const Alarm& alarm : previous) {
    const bool is_known = std::any_of(traffic.begin(), traffic.end(), [&](const Contact& contact) {
      return contact.id == alarm.id;
    });
    if (!is_known && alarm.status != AlarmStatus::lost) {
      result.push_back({alarm.id, AlarmStatus::lost, alarm.approach});
    }
  }
  return result;
}

}  // namespace slackwater::twin
