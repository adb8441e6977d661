#pragma once
#include <cmath>

namespace slackwater::api {

/// A number of the windows as it is told, and as a plan takes it: to the millionth.
[[nodiscard]] inline double as_told(double value) noexcept { return std::round(value * 1e6) / 1e6; }

}  // namespace slackwater::api
