#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "twin/traffic/closest_approach.h"

namespace slackwater::twin {

/// Another vessel, as known now.
struct Contact {
  std::uint32_t id = 0;  ///< its MMSI
  MovingPoint motion;
};

/// When a contact is a danger: its closest approach will be nearer than the distance and sooner
/// than the time (DCPA and TCPA), or it is nearer already. The operator's choice.
struct AlarmLimits {
  double distance_m = 0;
  double time_s = 0;
  /// An alarm once raised holds until both limits times this are left, so that noise in the reports
  /// does not ring it again and again. At least 1.
  double hold_factor = 1.25;
  bool operator==(const AlarmLimits&) const = default;
};

enum class AlarmStatus : std::uint8_t {
  raised,  ///< now
  held,    ///< of the last call
  lost,    ///< was an alarm, and now nobody knows where it is; said once
};

struct Alarm {
  std::uint32_t id = 0;
  AlarmStatus status = AlarmStatus::raised;
  ClosestApproach approach;  ///< of a lost contact: the last known
};

/// The alarms of this moment, in the order of the traffic, the lost ones behind.
/// @param previous  what the last call returned; nothing at first
/// @throws ContractViolation for limits that are not positive
[[nodiscard]] std::vector<Alarm> alarms(const MovingPoint& own, std::span<const Contact> traffic,
                                        const AlarmLimits& limits,
                                        std::span<const Alarm> previous = {});

}  // namespace slackwater::twin
