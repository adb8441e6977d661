#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fields/base/config.h"
#include "twin/scenario/source_place.h"

namespace slackwater::twin {

/// From a time on, what some actuators do; the others go on as the rows before have them.
struct ActuatorRow {
  double at_s = 0;                                      ///< since the task began
  std::vector<std::pair<std::string, double>> setting;  ///< `rudder_deg`: 10
  SourcePlace place;
  bool operator==(const ActuatorRow&) const = default;
};

/// Thrusters, fins and ballast as a table in time: steps, without an autopilot between. What it is
/// of is checked against the vehicle in `plan_actuators`.
struct ActuatorTable {
  std::vector<ActuatorRow> rows;  ///< `at_s` rising
  bool keeps_depth = false;       ///< by the autopilot, with what no row names
  bool keeps_heading = false;
  bool keeps_speed = false;
  std::optional<double> speed_m_s;  ///< to be kept; nothing: that of the vehicle
  SourcePlace place;
  bool operator==(const ActuatorTable&) const = default;
};

/// The unit at the end of a key of a row.
enum class KeyUnit { share, rad_s, rpm, n, deg, m3, m };
/// "_share", "_rad_s", ...
[[nodiscard]] std::string_view suffix_of(KeyUnit unit) noexcept;

struct ActuatorKey {
  std::string_view name;  ///< of the actuator: a part of the key
  KeyUnit unit{};
};
/// Nothing: it ends in no unit.
[[nodiscard]] std::optional<ActuatorKey> actuator_key(std::string_view key) noexcept;

/// `keep`, `speed_m_s` and `table` of a task.
/// @param lasts_s  the task: rows begin before that
[[nodiscard]] ActuatorTable read_actuator_table(const Config& task, double lasts_s);

}  // namespace slackwater::twin
