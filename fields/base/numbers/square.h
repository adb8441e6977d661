#pragma once

namespace slackwater {

[[nodiscard]] constexpr double square(double x) noexcept { return x * x; }

}  // namespace slackwater
