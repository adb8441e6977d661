#pragma once
#include <span>
#include <string>

#include "api/door/dds/message/bytes.h"
#include "fields/service/field.h"
#include "twin/traffic/alarms.h"

namespace slackwater::dds {

// What a site tells, as messages: towards, ENU, in frame `map`.

/// rosgraph_msgs/msg/Clock.
[[nodiscard]] Bytes clock(const Stamp& now);

/// Which water is asked, and where.
struct SiteWater {
  const Field& field;
  std::size_t member = 0;
  GeoPoint point;
};

/// slackwater_msgs/msg/CurrentProfile: the levels of the forecast down to the bed; east and north
/// of the member, p10 and p90 of the forecast (`quantiles_of`). Empty where there is no value.
[[nodiscard]] Bytes current_profile(const SiteWater& water, UtcTime time, const Stamp& stamp);
/// geometry_msgs/msg/Vector3Stamped: the mean wind at 10 m; no numbers where the forecast has none.
[[nodiscard]] Bytes wind(const SiteWater& water, UtcTime time, const Stamp& stamp);
/// slackwater_msgs/msg/SeaState.
[[nodiscard]] Bytes wave(const SeaSample& sea, const Stamp& stamp);
/// std_msgs/msg/Float64: of the sea above mean sea level, m.
[[nodiscard]] Bytes tide_level(const SiteWater& water, UtcTime time);
/// std_msgs/msg/Float64MultiArray: of each turbine in the site file's order, W.
[[nodiscard]] Bytes turbine_power(std::span<const double> power_w);

/// slackwater_msgs/msg/AisTarget.
struct AisTarget {
  std::uint32_t mmsi = 0;
  std::string name;
  GeoPoint point;
  double speed_m_s = 0;   ///< over ground
  double course_deg = 0;  ///< over ground, clockwise from north
  double cpa_m = 0;       ///< closest approach to any vehicle of the run; NaN: none foreseen
  double tcpa_s = 0;      ///< until then
};
[[nodiscard]] Bytes ais_target(const AisTarget& target, const Stamp& stamp);

}  // namespace slackwater::dds
