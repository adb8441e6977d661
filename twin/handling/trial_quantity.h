#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "twin/body/body.h"

namespace slackwater::twin {

/// What a column of a trial holds of the motion.
///
/// | quantity        | column            | what                                                |
/// |-----------------|-------------------|-----------------------------------------------------|
/// | north east down | _m                | place from any one point; depth_m is down_m         |
/// | roll pitch yaw  | _rad or _deg      | zyx; yaw clockwise from true north                  |
/// | u v w           | _m_s              | over the ground, in body axes: forward, right, down |
/// | p q r           | _rad_s or _deg_s  | rates of turn in body axes                          |
/// | speed           | _m_s              | over the ground, level, as a receiver has it        |
enum class TrialQuantity { north, east, down, roll, pitch, yaw, u, v, w, p, q, r, speed };

/// Its name as a column in SI has it: "yaw_rad". A literal.
[[nodiscard]] std::string_view name_of(TrialQuantity quantity) noexcept;
/// "m", "rad", "m/s", "rad/s".
[[nodiscard]] std::string_view unit_of(TrialQuantity quantity) noexcept;
/// Whether it comes back to itself after a turn.
[[nodiscard]] bool is_angle(TrialQuantity quantity) noexcept;

/// What a column's name says.
struct MeasuredName {
  TrialQuantity quantity{};
  double si = 1;  ///< what one of its unit is in SI
};
/// Nothing: it names no quantity.
[[nodiscard]] std::optional<MeasuredName> measured_name(std::string_view column) noexcept;
/// All names that `measured_name` knows.
[[nodiscard]] std::vector<std::string> measured_names();

/// In SI; of an angle the one in [-pi, pi].
[[nodiscard]] double value_of(TrialQuantity quantity, const BodyState<double>& body) noexcept;

}  // namespace slackwater::twin
